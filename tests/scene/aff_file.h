// AFF files of tests, read with stand-ins for images.
#pragma once
#include <gtest/gtest.h>

#include "server/scene/importer.h"
#include "tests/scene/files.h"

namespace raywalk::test {

inline std::filesystem::path aff_samples() {
  return scenes_dir() / "../tests/scene/data/aff";
}

/// Every image is two texels.
inline ImportSettings aff_settings(const std::filesystem::path& root = {}) {
  ImportSettings settings;
  settings.root = root;
  settings.decode = [](std::span<const u8>) { return Texture{"", 2, 1, {0xff, 0xff0000}}; };
  return settings;
}

inline Scene read_aff(const std::string& content) {
  const Folder folder;
  return load_mesh(folder.write("test.aff", content), aff_settings());
}

inline void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-5f) {
  EXPECT_LE(length(a - b), tolerance) << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " "
                                      << b.z;
}

/// Corner 0, 1 or 2 of a triangle.
inline u32 corner_of(const Scene& scene, size_t triangle, int corner) {
  const TriangleIndices& t = scene.triangles.at(triangle);
  return corner == 0 ? t.a : corner == 1 ? t.b : t.c;
}
inline Vec3 position_of(const Scene& scene, size_t triangle, int corner) {
  return scene.positions.at(corner_of(scene, triangle, corner));
}
inline Vec3 normal_of(const Scene& scene, size_t triangle, int corner) {
  return scene.normals.at(corner_of(scene, triangle, corner));
}

}  // namespace raywalk::test
