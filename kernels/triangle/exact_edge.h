// On which side of an edge a ray runs, exactly: the determinant of the direction and both ends as seen from the origin.
// All numbers are floats; whatever their size, no step over- or underflows in double.
#pragma once
#include "kernels/triangle/double3.h"
#include "kernels/triangle/exact_sum.h"

namespace raywalk::exact {

/// A line in space, infinite on both sides.
struct Line {
  Vec3 o, d;
};

namespace detail {

/// add(x, y) for six pairs of floats whose products sum up to a component of (p - o) x (q - o).
template <class Add>
RW_FN void for_products(Vec3 o, Vec3 p, Vec3 q, u32 axis, Add add) {
  const u32 j = axis == 2u ? 0u : axis + 1u, k = j == 2u ? 0u : j + 1u;
  const Vec3 ends[4] = {o, p, q, o};  // p x q + q x o + o x p
  for (u32 i = 0; i < 3; ++i) {
    add(ends[i][j], ends[i + 1][k]);
    add(-ends[i][k], ends[i + 1][j]);
  }
}

/// The exact sum of thirty-six products of three floats: the product of two floats is a double.
RW_SLOW_FN double determinant_by_sums(Line line, Vec3 p, Vec3 q) {
  ExactSum<36> sum;
  for (u32 axis = 0; axis < 3; ++axis)
    for_products(line.o, p, q, axis,
                 [&](float x, float y) { sum.add_product(double{x} * double{y}, double{line.d[axis]}); });
  return sum.value();
}

}  // namespace detail

/// det(d, p - o, q - o) with its exact sign. Its relative error is at most about 1 / margin, and below 2^-45 for zero
/// or wherever the filter is not enough.
RW_SLOW_FN double determinant(Line line, Vec3 p, Vec3 q, double margin) {
  const Double3 a = between(line.o, p), b = between(line.o, q), d = to_double(line.d);
  const double value = dot(d, cross(a, b));
  // Each product is rounded seven times, a and b included; 2^-49 has room for sixteen.
  const Double3 m = magnitude(d), s = magnitude(a), t = magnitude(b);
  const double sum = m.x * (s.y * t.z + s.z * t.y) + m.y * (s.z * t.x + s.x * t.z) + m.z * (s.x * t.y + s.y * t.x);
  if (magnitude(value) > margin * 0x1p-49 * sum) return value;
  return detail::determinant_by_sums(line, p, q);
}

/// 1 or -1 for an edge that the line meets exactly: the sign after moving the direction by (e, e^2, e^3) and the origin
/// by much less, in the same way, for an infinitely small e. All edges see the same line, so a closed surface is
/// crossed as if the line met no edge. 0 where that decides nothing: the edge is a point, or lies on the line.
RW_SLOW_FN i32 sign_on_edge(Line line, Vec3 p, Vec3 q) {
  for (u32 axis = 0; axis < 3; ++axis) {
    ExactSum<6> sum;
    detail::for_products(line.o, p, q, axis, [&](float x, float y) { sum.add(double{x} * double{y}); });
    if (sum.count != 0) return sum.value() > 0.0 ? 1 : -1;
  }
  for (u32 axis = 0; axis < 3; ++axis) {  // d x (q - p): the origin lies on the edge's own line
    const u32 j = axis == 2u ? 0u : axis + 1u, k = j == 2u ? 0u : j + 1u;
    ExactSum<4> sum;
    sum.add(double{line.d[j]} * double{q[k]});
    sum.add(-double{line.d[j]} * double{p[k]});
    sum.add(-double{line.d[k]} * double{q[j]});
    sum.add(double{line.d[k]} * double{p[j]});
    if (sum.count != 0) return sum.value() > 0.0 ? 1 : -1;
  }
  return 0;
}

}  // namespace raywalk::exact
