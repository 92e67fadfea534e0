// The test of Moeller and Trumbore (1997) in double precision, its answer rounded once. Edges belong to both
// neighbours, up to rounding: unlike the exact test it may leak at edges and vertices that the ray meets within 1e-16.
#pragma once
#include "kernels/ray.h"
#include "kernels/scene_view.h"
#include "kernels/triangle/double3.h"

namespace raywalk {

struct MoellerTrumboreDouble {
  Vec3 o;
  Double3 d;

  MoellerTrumboreDouble() = default;
  RW_FN explicit MoellerTrumboreDouble(const Ray& ray) : o(ray.o), d(to_double(ray.d)) {}
};

/// As `intersect` of the watertight test, but edges and vertices count for all triangles around them.
RW_FN bool intersect(const MoellerTrumboreDouble& ray, const Corners& triangle, float& t, float& u, float& v) {
  const Double3 ab = between(triangle.a, triangle.b), ac = between(triangle.a, triangle.c);
  const Double3 from_a = between(triangle.a, ray.o);
  const Double3 p = cross(ray.d, ac);
  const double det = dot(ab, p);
  if (!(magnitude(det) > 0.0)) return false;
  const double inverse = 1.0 / det;
  const double weight_b = dot(from_a, p) * inverse;
  if (!(weight_b >= 0.0 && weight_b <= 1.0)) return false;
  const Double3 q = cross(from_a, ab);
  const double weight_c = dot(ray.d, q) * inverse;
  if (!(weight_c >= 0.0 && weight_b + weight_c <= 1.0)) return false;
  t = static_cast<float>(dot(ac, q) * inverse);
  u = static_cast<float>(weight_b);
  v = static_cast<float>(weight_c);
  return is_finite(t);
}

}  // namespace raywalk
