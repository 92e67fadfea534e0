// A scene on the host: what every importer and generator produces, and its packing into a kernel blob.
#pragma once
#include <string>
#include <vector>

#include "kernels/blob_writer.h"
#include "kernels/scene_view.h"
#include "server/scene/camera_path.h"

namespace raywalk {

/// How near the geometry is to the scene whose name it bears.
enum class Fidelity {
  kOriginal,    // the very data of the study
  kDerived,     // made from it (another resolution, another tessellation, an altered file)
  kStandIn,     // generated in its place, with the same triangle count
  kProcedural,  // generated, and nothing else is meant
};

/// "original", "derived", "stand-in", "procedural".
const char* fidelity_name(Fidelity fidelity);

/// An image: sRGB texels as the kernels read them (SceneHeader::texels), rows top down.
struct Texture {
  std::string name;
  u32 width = 0, height = 0;
  std::vector<u32> texels;
};

/// A view that the scene's file names.
struct NamedCamera {
  std::string name;
  CameraPose pose;
};

struct Scene {
  std::string name;
  std::string source;  // where the geometry came from, for people
  Fidelity fidelity = Fidelity::kOriginal;
  std::string fidelity_note;  // how it differs from the study's scene; empty if it does not, or there is none
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;        // one a vertex (zero: none), or none at all
  std::vector<TexCoord> texcoords;  // one a vertex, or none at all
  std::vector<TriangleIndices> triangles;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Light> lights;
  std::vector<NamedCamera> cameras;
  Vec3 background{};
  Vec3 ambient{};
  CameraPath camera_path;
  bool has_camera_path = false;  // camera_path came with the file
  std::vector<std::string> warnings;
  std::string content_sha256;  // of the geometry (see geometry_sha256), lower-case hex; set by load_scene and load_mesh
};

/// A neutral grey plastic, the material of meshes that bring none.
Material default_material();

/// Box of all triangles whose vertices are finite; empty when there is none.
Box bounds_of(const Scene& scene);

/// Mask of kernels/features.h for exactly this scene.
u32 features_of(const Scene& scene);

/// The kernel blob (SceneHeader), textures with their smaller versions. Allocates the blob and little else.
/// Throws std::invalid_argument if a vertex, material or texture index is out of range, normals or texture coordinates
/// do not match the vertices, or a texture has not width * height texels.
Blob pack(const Scene& scene);

/// SHA-256 over positions, normals and triangles with their counts, little-endian: equal geometry, equal hash.
std::string geometry_sha256(const Scene& scene);

}  // namespace raywalk
