// A triangle as the map that takes space to its barycentric coordinates: Baldwin and Weber, "Fast Ray-Triangle
// Intersections by Coordinate Transformation", JCGT 5(3), 2016. The map's free column is chosen so that a third of its
// coefficients need no storage: those of the axis along which the triangle's normal is largest.
#pragma once
#include "kernels/scene_view.h"
#include "kernels/triangle/double3.h"

namespace raywalk {

/// 48 bytes, the id where `Corners` has it. For a point p with its components turned so that `axis` comes first,
/// (h, i, j): u = to_u . (i, j, 1), v = to_v . (i, j, 1), and p lies to_plane . (i, j, 1) + h above the plane, measured
/// along `axis`.
struct alignas(16) Transform {
  Vec3 to_u;
  u32 id;
  Vec3 to_v;
  u32 axis;
  Vec3 to_plane;
  u32 pad;
};

/// The components of `a` from `axis` on, cyclically.
RW_FN Vec3 turned(Vec3 a, u32 axis) {
  return axis == 0u ? a : axis == 1u ? Vec3{a.y, a.z, a.x} : Vec3{a.z, a.x, a.y};
}
RW_FN Double3 turned(Double3 a, u32 axis) {
  return axis == 0u ? a : axis == 1u ? Double3{a.y, a.z, a.x} : Double3{a.z, a.x, a.y};
}

/// Computed in double and rounded once. Degenerate and non-finite triangles, and those whose map is beyond the floats,
/// become a record of finite numbers that no ray meets.
RW_FN Transform transform_of(const Corners& triangle) {
  const Transform never{{0, 0, -1}, triangle.id, {0, 0, 0}, 0, {0, 0, 0}, 0};
  if (!is_finite(triangle)) return never;
  const Double3 m = magnitude(cross(between(triangle.a, triangle.b), between(triangle.a, triangle.c)));
  const u32 axis = m.x >= m.y && m.x >= m.z ? 0u : m.y >= m.z ? 1u : 2u;
  const Double3 a = turned(to_double(triangle.a), axis);
  const Double3 ab = turned(between(triangle.a, triangle.b), axis), ac = turned(between(triangle.a, triangle.c), axis);
  const Double3 n = cross(ab, ac);
  if (!(magnitude(n.x) > 0.0)) return never;
  const auto row = [](double y, double z, double one) {
    return Vec3{static_cast<float>(y), static_cast<float>(z), static_cast<float>(one)};
  };
  const Transform made{row(ac.z / n.x, -ac.y / n.x, (a.z * ac.y - a.y * ac.z) / n.x),
                       triangle.id,
                       row(-ab.z / n.x, ab.y / n.x, (a.y * ab.z - a.z * ab.y) / n.x),
                       axis,
                       row(n.y / n.x, n.z / n.x, -dot(n, a) / n.x),
                       0};
  return is_finite(made.to_u) && is_finite(made.to_v) && is_finite(made.to_plane) ? made : never;
}

}  // namespace raywalk
