// One ray against the boxes of both children of a node at once.
#pragma once
#include "kernels/accel/bvh/layout.h"
#include "kernels/accel/slab.h"

namespace raywalk::bvh {

/// Whether a ray meets the boxes of the left and the right child, and the distances at which it enters those.
struct PairEntries {
  float left, right;
  bool meets_left, meets_right;
};

#if RW_GPU

/// A ray's constants for `entries_of`.
template <class Slab>
struct PairSlabs : SlabRay {
  RW_FN PairSlabs(const Ray& ray, const Header& header)
      : SlabRay(slab_ray<Slab>(ray, header.centre, header.half_extent)) {}
};

/// The interval that counts.
struct PairLimits {
  float tmin, tmax;
};

// Floats compared as integers: twice as fast, and right among numbers that are not negative. Where tmin is negative the
// order of negative numbers turns round, which makes entries earlier and exits later: boxes too many, never too few.
// A NaN in `t` is dropped where there can be one.
template <class Slab>
RW_FN float later(float t, float entry) {
  if constexpr (Slab::kInfinities) return larger(t, entry);
  return float_of(static_cast<u32>(::max(static_cast<i32>(bits_of(t)), static_cast<i32>(bits_of(entry)))));
}
template <class Slab>
RW_FN float earlier(float t, float exit) {
  if constexpr (Slab::kInfinities) return smaller(t, exit);
  return float_of(static_cast<u32>(::min(static_cast<i32>(bits_of(t)), static_cast<i32>(bits_of(exit)))));
}

template <class Slab, class NodeT>
RW_FN PairEntries entries_of(const PairSlabs<Slab>& s, const NodeT& node, float unit, PairLimits limits) {
  float entry[2] = {limits.tmin, limits.tmin}, exit[2] = {limits.tmax, limits.tmax};
  for (u32 axis = 0; axis < 3; ++axis) {
    const Float4 p = node.row(axis, unit);
    const float inverse = s.inverse[axis], inverse_far = s.inverse_far[axis];
    const float near = s.near[axis], far = s.far[axis];
    const bool ascending = bits_of(inverse) >> 31 == 0;
    entry[0] = later<Slab>(crossing<Slab>(ascending ? p.x : p.z, inverse, near), entry[0]);
    entry[1] = later<Slab>(crossing<Slab>(ascending ? p.y : p.w, inverse, near), entry[1]);
    exit[0] = earlier<Slab>(crossing<Slab>(ascending ? p.z : p.x, inverse_far, far), exit[0]);
    exit[1] = earlier<Slab>(crossing<Slab>(ascending ? p.w : p.y, inverse_far, far), exit[1]);
  }
  return {entry[0], entry[1], entry[0] <= widened<Slab>(exit[0]), entry[1] <= widened<Slab>(exit[1])};
}

#else

/// Far distances are kept negated, so that one maximum narrows the near and the far side of both children.
template <class Slab>
struct PairSlabs {
  Float4 inverse[3], offset[3];
  HalfSwap swap[3];

  RW_FN PairSlabs(const Ray& ray, const Header& header) {
    const SlabRay s = slab_ray<Slab>(ray, header.centre, header.half_extent);
    set<0>(s);
    set<1>(s);
    set<2>(s);
  }

 private:
  template <int axis>
  RW_FN void set(const SlabRay& s) {
    inverse[axis] = pair_of<axis>(s.inverse, -s.inverse_far);
    offset[axis] = pair_of<axis>(s.near, Slab::kInfinities ? s.far : -s.far);
    swap[axis] = half_swap<axis>(s.inverse);
  }
};

struct PairLimits {
  Float4 values;
  RW_FN PairLimits(float tmin, float tmax) : values{tmin, tmin, -tmax, -tmax} {}
};

template <class Slab, class NodeT>
RW_FN PairEntries entries_of(const PairSlabs<Slab>& s, const NodeT& node, float unit, const PairLimits& limits) {
  const auto crossings = [&](u32 axis) {
    const Float4 planes = swapped(node.row(axis, unit), s.swap[axis]);
    if constexpr (Slab::kInfinities) return (planes - s.offset[axis]) * s.inverse[axis];
    return fma(planes, s.inverse[axis], s.offset[axis]);
  };
  const Float4 x = crossings(0), y = crossings(1), z = crossings(2);
  Float4 t;
  if constexpr (Slab::kInfinities) {  // one after the other, so that a NaN is dropped
    const float far = widened<Slab>(1.0f);
    t = larger(x, larger(y, larger(z, limits.values))) * Float4{1.0f, 1.0f, far, far};
  } else {
    t = larger(larger(x, y), larger(z, limits.values));
  }
  const u32 ordered = ordered_pairs(t);
  return {t[0], t[1], (ordered & 1u) != 0, (ordered & 2u) != 0};
}

#endif

}  // namespace raywalk::bvh
