// Polygons into triangles by ear clipping.
#pragma once
#include <span>
#include <vector>

#include "kernels/vec.h"

namespace raywalk {

/// Cuts a simple polygon in space (concave or not, nearly flat) into exactly n - 2 triangles with the polygon's
/// winding. `corners` are indices into `positions`; the result has three of them a triangle. A polygon that is no
/// simple one (repeated, collinear or crossing corners) still gives n - 2 triangles, some of them thin. n < 3 gives
/// none. Time is quadratic in n for usual polygons.
std::vector<u32> triangulate(std::span<const u32> corners, std::span<const Vec3> positions);

}  // namespace raywalk
