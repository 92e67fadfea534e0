// A scene under construction: what the loaders of all formats share.
#pragma once
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/scene/import_files.h"

namespace raywalk {

/// A corner of a polygon. A zero normal means none.
struct MeshCorner {
  Vec3 position{};
  Vec3 normal{};
  TexCoord texcoord{};
};

class SceneBuilder {
 public:
  explicit SceneBuilder(ImportFiles& files);

  /// Index of a new material. Throws std::runtime_error beyond 65,536 of them.
  u32 add_material(const Material& material);
  /// Index for Material::texture of the image `name`, looked for in the folders in turn, and decoded once. One that is
  /// missing, outside the root or unreadable is a magenta checker and a warning that begins with `place`.
  u32 add_texture(std::string_view name, std::initializer_list<std::filesystem::path> folders,
                  const std::string& place);
  /// The same for an image inside another file; `name` tells it from others.
  u32 add_texture(std::string_view name, std::span<const u8> bytes, const std::string& place);
  void add_light(const Light& light) { scene_.lights.push_back(light); }
  void add_camera(NamedCamera camera) { scene_.cameras.push_back(std::move(camera)); }

  /// Index of a new vertex.
  u32 add_vertex(const MeshCorner& corner);
  /// Throws std::runtime_error when there are more than the limit of triangles.
  void add_triangle(TriangleIndices triangle);
  /// Throws std::runtime_error if no polygon may have so many: for readers that know before they have read them.
  static void check_corners(size_t count);
  /// Cut into n - 2 triangles; one with fewer than three corners is counted and left out.
  void add_polygon(std::span<const MeshCorner> corners, u32 material);
  /// The same of vertices that are already there.
  void add_polygon(std::span<const u32> vertices, u32 material);

  /// `place` is "<file>, line <n>" or the like. After a hundred warnings the rest is only counted.
  void warn(const std::string& place, const std::string& message);

  /// What is neither geometry nor material (ambient, background, camera path) is set here directly.
  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  /// The scene, with at least one material. Attributes that no vertex has are dropped; what was left out, and vertices
  /// that are not finite, become warnings.
  Scene finish();

 private:
  u32 checker();
  u32 keep(const std::string& key, Texture texture);

  ImportFiles& files_;
  Scene scene_;
  std::map<std::string, u32, std::less<>> texture_of_;
  u64 texels_left_;
  u64 not_finite_ = 0, not_faces_ = 0, unshown_warnings_ = 0;
  bool has_normals_ = false, has_texcoords_ = false;
  std::vector<u32> corners_;  // of one polygon
};

/// "<file>, line <n>".
std::string at_line(const std::filesystem::path& file, u64 line);

}  // namespace raywalk
