// MGF for tests: files of ours, text, and what came of them.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "server/scene/importer.h"
#include "tests/scene/files.h"

namespace raywalk::test {

inline std::filesystem::path mgf_sample(const std::string& name) {
  return scenes_dir().parent_path() / "tests/scene/data/mgf" / name;
}

inline Scene mgf_scene(const std::string& text, ImportSettings settings = {}) {
  const Folder folder;
  return load_mesh(folder.write("a.mgf", text), std::move(settings));
}

inline std::string mgf_error(const std::string& text) {
  return message_of([&] { mgf_scene(text); });
}

/// Four vertices of the unit square in z = 0, called a b c d; from above they turn left.
inline const std::string kMgfSquare = "v a =\np 0 0 0\nv b =\np 1 0 0\nv c =\np 1 1 0\nv d =\np 0 1 0\n";

inline std::array<Vec3, 3> corners_of(const Scene& scene, size_t triangle) {
  const TriangleIndices t = scene.triangles[triangle];
  return {scene.positions[t.a], scene.positions[t.b], scene.positions[t.c]};
}

/// Area times the normal that the winding gives.
inline Vec3 area_of(const Scene& scene, size_t triangle) {
  const auto [a, b, c] = corners_of(scene, triangle);
  return 0.5f * cross(b - a, c - a);
}

/// Six times the volume is the sum; positive when all of a closed surface faces outwards.
inline double volume_of(const Scene& scene, size_t first, size_t count) {
  double sum = 0.0;
  for (size_t i = first; i < first + count; ++i) {
    const auto [a, b, c] = corners_of(scene, i);
    sum += dot(a, cross(b, c)) / 6.0;
  }
  return sum;
}

}  // namespace raywalk::test
