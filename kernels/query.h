// What a traversal asks of each triangle: the closest hit, or whether there is any. A traversal is compiled once for
// each.
#pragma once
#include "kernels/triangle/watertight.h"

namespace raywalk {

/// Keeps the hit with the smallest (t, id).
struct ClosestHit {
  static constexpr bool kAny = false;
  WatertightRay ray;
  float tmin;
  Hit best;

  ClosestHit() = default;
  RW_FN explicit ClosestHit(const Ray& r) : ray(r), tmin(r.tmin), best(miss_of(r)) {}
  /// Farther than this nothing matters; a hit at exactly this t may still win by its id.
  RW_FN float tmax() const { return best.t; }
  /// True when the traversal is finished.
  RW_FN bool test(const Corners& triangle) {
    float t, u, v;
    if (intersect(ray, triangle, t, u, v) && t >= tmin && closer(t, triangle.id, best)) best = {t, triangle.id, u, v};
    return false;
  }
};

/// Stops at the first hit inside the interval.
struct AnyHit {
  static constexpr bool kAny = true;
  WatertightRay ray;
  float tmin, limit;
  bool occluded;

  AnyHit() = default;
  RW_FN explicit AnyHit(const Ray& r) : ray(r), tmin(r.tmin), limit(r.tmax), occluded(false) {}
  RW_FN float tmax() const { return limit; }
  RW_FN bool test(const Corners& triangle) {
    float t, u, v;
    occluded = intersect(ray, triangle, t, u, v) && t >= tmin && t <= limit;
    return occluded;
  }
};

}  // namespace raywalk
