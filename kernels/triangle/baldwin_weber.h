// The ray-triangle test of Baldwin and Weber (2016) on precomputed transforms: the fewest operations of all. Not
// watertight, and its coefficients are absolute: far from the coordinates' origin they lose the triangle's digits.
#pragma once
#include "kernels/ray.h"
#include "kernels/triangle/transform.h"

namespace raywalk {

struct BaldwinWeber {
  using Record = Transform;
  Vec3 o, d;

  BaldwinWeber() = default;
  RW_FN explicit BaldwinWeber(const Ray& ray) : o(ray.o), d(ray.d) {}
};

/// As `intersect` of the watertight test, but edges and vertices count for all triangles around them, up to rounding.
RW_FN bool intersect(const BaldwinWeber& ray, const Transform& to, float& t, float& u, float& v) {
  const Vec3 o = turned(ray.o, to.axis), d = turned(ray.d, to.axis);
  const float height = fma(to.to_plane.x, o.y, fma(to.to_plane.y, o.z, to.to_plane.z)) + o.x;
  const float climb = fma(to.to_plane.x, d.y, fma(to.to_plane.y, d.z, d.x));
  t = divide(-height, climb);
  const float y = fma(t, d.y, o.y), z = fma(t, d.z, o.z);
  u = fma(to.to_u.x, y, fma(to.to_u.y, z, to.to_u.z));
  v = fma(to.to_v.x, y, fma(to.to_v.y, z, to.to_v.z));
  return u >= 0.0f && v >= 0.0f && u + v <= 1.0f && is_finite(t);
}

}  // namespace raywalk
