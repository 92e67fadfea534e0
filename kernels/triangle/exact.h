// Ray-triangle test without any error in hit or miss, for all finite floats: a filter in float, where that leaves a
// sign open one in double, and where that does too exact sums. An edge or a vertex that the ray meets exactly belongs
// to one of the triangles around it; a ray in a triangle's plane misses it.
#pragma once
#include "kernels/ray.h"
#include "kernels/scene_view.h"
#include "kernels/triangle/exact_edge.h"

namespace raywalk {

/// The ray and its slopes along its main axis kz.
struct Exact {
  exact::Line line;
  u32 kx, ky, kz;
  float sx, sy;
  float ox, oy, oz;  // the origin's components kx, ky, kz

  Exact() = default;
  RW_FN explicit Exact(const Ray& ray) : line{ray.o, ray.d} {
    const Vec3 m = magnitude(ray.d);
    kz = m.x > m.y ? (m.x > m.z ? 0u : 2u) : (m.y > m.z ? 1u : 2u);
    kx = kz == 2u ? 0u : kz + 1u;
    ky = kx == 2u ? 0u : kx + 1u;
    sx = divide(ray.d[kx], ray.d[kz]);
    sy = divide(ray.d[ky], ray.d[kz]);
    ox = ray.o[kx];
    oy = ray.o[ky];
    oz = ray.o[kz];
  }
};

namespace exact {

/// Whether the line meets the triangle; for what the float filter leaves open.
RW_FN bool is_met(const Line& line, const Corners& triangle) {
  if (!is_finite(triangle)) return false;
  const Vec3 corner[4] = {triangle.a, triangle.b, triangle.c, triangle.a};
  u32 above = 0, below = 0, zeros = 0;
  for (u32 i = 0; i < 3; ++i) {
    const double w = determinant(line, corner[i], corner[i + 1], 1.0);
    if (w == 0.0) ++zeros;
    const i32 sign = w > 0.0 ? 1 : w < 0.0 ? -1 : sign_on_edge(line, corner[i], corner[i + 1]);
    if (sign > 0) ++above;
    if (sign < 0) ++below;
  }
  return zeros < 3 && (above == 3 || below == 3);
}

/// Where a line meets a triangle: the distance, and the weights of b and c.
struct Meeting {
  double t, u, v;
};

/// For a triangle that is met at a grazing angle or is a sliver: the mean of the corners by weights that are exact, so
/// that it never leaves the corners' own range.
RW_SLOW_FN Meeting mean_of_corners(Line line, const Corners& triangle) {
  constexpr double kMargin = 0x1p30;
  const double wa = determinant(line, triangle.b, triangle.c, kMargin);
  const double wb = determinant(line, triangle.c, triangle.a, kMargin);
  const double wc = determinant(line, triangle.a, triangle.b, kMargin);
  const double sum = wa + wb + wc, u = wb / sum, v = wc / sum;
  const Vec3 m = magnitude(line.d);
  const u32 axis = m.x > m.y ? (m.x > m.z ? 0u : 2u) : (m.y > m.z ? 1u : 2u);
  const double o = line.o[axis];
  const double along = wa / sum * (triangle.a[axis] - o) + u * (triangle.b[axis] - o) + v * (triangle.c[axis] - o);
  return {along / line.d[axis], u, v};
}

/// The t of a triangle that is not met is beyond the floats. `certain`: a filter has found that it is met if it is
/// finite. One call for both questions, since each costs a GPU the registers around it.
RW_SLOW_FN Meeting meet(Line line, const Corners& triangle, bool certain) {
  constexpr Meeting kNone{2.0 * double{kMaxFloat}, 0.0, 0.0};
  if (!certain && !is_met(line, triangle)) return kNone;
  const Double3 ab = between(triangle.a, triangle.b), ac = between(triangle.a, triangle.c);
  const Double3 from_a = between(triangle.a, line.o), d = to_double(line.d);
  const Double3 p = cross(d, ac);
  const double det = dot(ab, p);
  // Where det keeps 30 bits, so does t, with errors of 2^-50 of the three lengths and some to spare.
  const double lengths = largest(magnitude(d)) * largest(magnitude(ab)) * largest(magnitude(ac));
  if (magnitude(det) > 0x1p-16 * lengths) {
    const Double3 q = cross(from_a, ab);
    const double inverse = 1.0 / det;
    return {dot(ac, q) * inverse, dot(from_a, p) * inverse, dot(d, q) * inverse};
  }
  return is_finite(triangle) ? mean_of_corners(line, triangle) : kNone;
}

/// A bound on the error of the edge functions, given the largest |x| or |y| and the largest |z| of the corners as
/// sheared: with u = 2^-24 and R = S + Z, translation and shear err by at most u (2 S + 3 Z) < 4 u R = E, the edge
/// functions by 4 E S + 2 E^2 for that and by 3 u S^2 < E S for their own rounding. 6 E S + 3 E^2 leaves room for the
/// rounding of the bound. Constants stand for underflow; S^2 beyond the floats makes it infinite or NaN.
RW_FN float edge_error(float s, float z) {
  const float r = (s + 0x1p-96f) + z, e = r * 0x1p-22f;
  return fma(r * fma(6.0f, s, 3.0f * e), 0x1p-22f, 0x1p-120f);
}

}  // namespace exact

/// As `intersect` of the watertight test, but without a limit to the triangle's size. t is rounded once from an error
/// below 2^-30 where the triangle is met at an angle; else it stays within the corners' range.
RW_FN bool intersect(const Exact& ray, const Corners& triangle, float& t, float& u, float& v) {
  const float *a = &triangle.a.x, *b = &triangle.b.x, *c = &triangle.c.x;
  const float az = a[ray.kz] - ray.oz, bz = b[ray.kz] - ray.oz, cz = c[ray.kz] - ray.oz;
  const float ax = fma(-ray.sx, az, a[ray.kx] - ray.ox), ay = fma(-ray.sy, az, a[ray.ky] - ray.oy);
  const float bx = fma(-ray.sx, bz, b[ray.kx] - ray.ox), by = fma(-ray.sy, bz, b[ray.ky] - ray.oy);
  const float cx = fma(-ray.sx, cz, c[ray.kx] - ray.ox), cy = fma(-ray.sy, cz, c[ray.ky] - ray.oy);
  const float wa = fma(cx, by, -(cy * bx)), wb = fma(ax, cy, -(ay * cx)), wc = fma(bx, ay, -(by * ax));
  const float s = larger(larger(larger(magnitude(ax), magnitude(ay)), larger(magnitude(bx), magnitude(by))),
                         larger(magnitude(cx), magnitude(cy)));
  const float z = larger(magnitude(az), larger(magnitude(bz), magnitude(cz)));
  const float error = exact::edge_error(s, z);
  const float low = smaller(wa, smaller(wb, wc)), high = larger(wa, larger(wb, wc));
  if (low < -error && high > error) return false;
  // A NaN may have been dropped: then `meet` finds a corner that is not finite.
  const exact::Meeting meeting = exact::meet(ray.line, triangle, low > error || high < -error);
  t = static_cast<float>(meeting.t);
  u = static_cast<float>(larger(meeting.u, 0.0));
  v = static_cast<float>(larger(meeting.v, 0.0));
  return is_finite(t);
}

}  // namespace raywalk
