// What a traversal asks of each triangle: the closest hit, or whether there is any. A traversal is compiled once for
// each and for each set of knobs. An intersector is a ray prepared for one of the tests of kernels/triangle.
#pragma once
#include "kernels/knobs.h"
#include "kernels/triangle/baldwin_weber.h"
#include "kernels/triangle/double.h"
#include "kernels/triangle/exact.h"
#include "kernels/triangle/moeller_trumbore.h"
#include "kernels/triangle/watertight.h"

namespace raywalk {

/// What an intersector reads of a triangle: the corners, unless it names another type.
template <class Intersector>
struct RecordOf {
  using Type = Corners;
};
template <class Intersector>
requires requires {
  typename Intersector::Record;
}
struct RecordOf<Intersector> {
  using Type = typename Intersector::Record;
};

/// Keeps the hit with the smallest (t, id).
template <class KnobsT>
struct ClosestHitBy {
  using Knobs = KnobsT;
  using Intersector = typename Knobs::Intersector;
  using Record = typename RecordOf<Intersector>::Type;
  static constexpr bool kAny = false;
  Intersector ray;
  float tmin;
  Hit best;
  u32 stack_entries = kStackEntries;  // of a short stack on the CPU

  ClosestHitBy() = default;
  RW_FN explicit ClosestHitBy(const Ray& r) : ray(r), tmin(r.tmin), best(miss_of(r)) {}
  /// Farther than this nothing matters; a hit at exactly this t may still win by its id.
  RW_FN float tmax() const { return best.t; }
  /// True when the traversal is finished.
  RW_FN bool test(const Record& triangle) {
    float t, u, v;
    if (intersect(ray, triangle, t, u, v) && t >= tmin && closer(t, triangle.id, best)) best = {t, triangle.id, u, v};
    return false;
  }
};

/// Stops at the first hit inside the interval.
template <class KnobsT>
struct AnyHitBy {
  using Knobs = KnobsT;
  using Intersector = typename Knobs::Intersector;
  using Record = typename RecordOf<Intersector>::Type;
  static constexpr bool kAny = true;
  Intersector ray;
  float tmin, limit;
  bool occluded;
  u32 stack_entries = kStackEntries;

  AnyHitBy() = default;
  RW_FN explicit AnyHitBy(const Ray& r) : ray(r), tmin(r.tmin), limit(r.tmax), occluded(false) {}
  RW_FN float tmax() const { return limit; }
  RW_FN bool test(const Record& triangle) {
    float t, u, v;
    occluded = intersect(ray, triangle, t, u, v) && t >= tmin && t <= limit;
    return occluded;
  }
};

using ClosestHit = ClosestHitBy<StrictKnobs>;
using AnyHit = AnyHitBy<StrictKnobs>;

}  // namespace raywalk
