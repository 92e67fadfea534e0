// scenes/<name>/scene.json, read and checked.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "server/scene/scene.h"

namespace raywalk {

/// An orbit whose size follows the scene's bounds.
struct OrbitPlan {
  std::optional<Vec3> centre;  // of the bounds when absent
  float radius_factor;         // times half the diagonal of the bounds
  float elevation_deg, start_deg, turns, vertical_fov_deg;
};

/// All of a scene but its geometry.
struct Appearance {
  std::vector<Material> materials;
  std::vector<Light> lights;
  Vec3 ambient, background;
  std::variant<OrbitPlan, SplinePath> camera;
  u32 frames;

  CameraPath camera_path(const Box& bounds) const;
};

/// What an original takes from its own file instead of its appearance in the manifest.
struct FromFile {
  bool materials = false, ambient = false, background = false, camera = false;
  std::vector<u32> lights;  // these of the file's lights, if any are named
};

struct OriginalSource {
  std::filesystem::path file;                 // inside the folder of original data, with forward slashes
  std::string sha256;                         // of its uncompressed contents
  u64 triangles;                              // that the file has
  std::optional<u64> split_to;                // triangles after splitting
  std::optional<u32> cone_slices;             // 0 leaves its cones out
  std::optional<std::pair<u32, u32>> sphere;  // slices and stacks of its spheres, where not the format's own
  Fidelity fidelity;                          // kOriginal or kDerived
  std::string change;                         // what differs from the study's scene, in words; empty if nothing does
  std::string credit;
  std::string home_url;  // of the file or of an archive that holds it; empty if it cannot be downloaded as it is
  Appearance appearance;
  FromFile from_file;

  u64 shown_triangles() const { return split_to.value_or(triangles); }
  u64 light_count() const { return from_file.lights.empty() ? appearance.lights.size() : from_file.lights.size(); }
};

struct GeneratorSource {
  std::string name;
  u64 triangles;
};

struct Manifest {
  std::string name;  // of the folder
  std::string title, prose;
  std::optional<OriginalSource> original;
  std::optional<GeneratorSource> generator;  // at least one of the two is there
  Appearance appearance;                     // of the generated scene, and of the original where it says nothing
  std::string paper_json;
};

/// Throws std::runtime_error naming the file, and the JSON pointer of what is wrong.
Manifest read_manifest(const std::filesystem::path& file);

}  // namespace raywalk
