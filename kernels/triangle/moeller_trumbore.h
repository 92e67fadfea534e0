// The usual fast ray-triangle test: Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1),
// 1997. Not watertight: near an edge its rounding depends on the triangle, so a ray may slip between two neighbours.
#pragma once
#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk {

struct MoellerTrumbore {
  Vec3 o, d;

  MoellerTrumbore() = default;
  RW_FN explicit MoellerTrumbore(const Ray& ray) : o(ray.o), d(ray.d) {}
};

/// As `intersect` of the watertight test; cross products here are plain ones, each product rounded.
RW_FN bool intersect(const MoellerTrumbore& ray, const Corners& triangle, float& t, float& u, float& v) {
  const auto plain_cross = [](Vec3 a, Vec3 b) {
    return Vec3{fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x))};
  };
  const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Vec3 p = plain_cross(ray.d, ac);
  const float det = dot(ab, p);
  if (!(magnitude(det) > 0.0f)) return false;
  const float inverse = reciprocal(det);
  const Vec3 from_a = ray.o - triangle.a;
  u = dot(from_a, p) * inverse;
  const Vec3 q = plain_cross(from_a, ab);
  v = dot(ray.d, q) * inverse;
  if (!(u >= 0.0f && v >= 0.0f && u + v <= 1.0f)) return false;
  t = dot(ac, q) * inverse;
  return is_finite(t);
}

}  // namespace raywalk
