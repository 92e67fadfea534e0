// The faces or strips of a shape as lists of corners, and normals where a file brings none.
#pragma once
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

/// Corners of faces or strips, one after the other.
struct IvFaces {
  struct Corner {
    u32 coordinate;
    u32 slot;   // its place in the index lists of the shape
    u32 order;  // corners before it
  };
  std::vector<Corner> corners;
  std::vector<size_t> ends;  // of each face among the corners

  u32 count() const { return static_cast<u32>(ends.size()); }
  std::span<const Corner> face(u32 index) const {
    const size_t begin = index == 0 ? 0 : ends[index - 1];
    return std::span(corners).subspan(begin, ends[index] - begin);
  }
};

/// Point `index` of a list of triples.
inline glm::dvec3 triple(std::span<const double> list, u64 index) {
  return {list[3 * index], list[3 * index + 1], list[3 * index + 2]};
}

/// A normal for each corner: the mean of the faces that meet there and lie within `crease_angle` radians of its own.
std::vector<glm::dvec3> smooth_normals(const IvFaces& faces, std::span<const double> coordinates, double crease_angle);

}  // namespace raywalk
