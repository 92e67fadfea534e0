// The two sinks that keep something: one fills a scene, one writes a PLY file as it goes.
#pragma once
#include <filesystem>
#include <fstream>

#include "server/scene/scene.h"
#include "server/scene/triangle_sink.h"

namespace raywalk {

/// Fills positions, normals and triangles.
class SceneSink : public TriangleSink {
 public:
  explicit SceneSink(Scene& scene) : scene_(scene) {}
  void begin(MeshCounts counts) override;
  u32 add_vertex(Vec3 position, Vec3 normal) override;
  void add_triangle(TriangleIndices triangle) override;

 private:
  Scene& scene_;
};

/// Writes binary little-endian PLY with normals and material_index, in memory that does not grow with the mesh: the
/// counts give the place of the faces, so vertices and faces are written side by side.
class PlySink : public TriangleSink {
 public:
  /// The file is made by begin(). That and the calls below throw std::runtime_error naming it if it cannot be written.
  explicit PlySink(std::filesystem::path path) : path_(std::move(path)) {}
  void begin(MeshCounts counts) override;
  u32 add_vertex(Vec3 position, Vec3 normal) override;
  void add_triangle(TriangleIndices triangle) override;
  /// Call last: checks that everything that was announced has come and reached the file.
  void finish();

 private:
  void check(bool ok, const char* what) const;

  std::filesystem::path path_;
  std::ofstream vertices_;
  std::fstream faces_;
  MeshCounts announced_, written_;
};

}  // namespace raywalk
