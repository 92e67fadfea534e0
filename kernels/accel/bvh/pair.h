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
struct PairSlabs : SlabRay {
  RW_FN PairSlabs(const Ray& ray, const Header& header) : SlabRay(slab_ray(ray, header.centre, header.half_extent)) {}
};

/// The interval that counts.
struct PairLimits {
  float tmin, tmax;
};

// Floats compared as integers: twice as fast, and right among numbers that are not negative. Where tmin is negative the
// order of negative numbers turns round, which makes entries earlier and exits later: boxes too many, never too few.
RW_FN float later(float a, float b) {
  return float_of(static_cast<u32>(::max(static_cast<i32>(bits_of(a)), static_cast<i32>(bits_of(b)))));
}
RW_FN float earlier(float a, float b) {
  return float_of(static_cast<u32>(::min(static_cast<i32>(bits_of(a)), static_cast<i32>(bits_of(b)))));
}

RW_FN PairEntries entries_of(const PairSlabs& s, const Node& node, PairLimits limits) {
  float entry[2] = {limits.tmin, limits.tmin}, exit[2] = {limits.tmax, limits.tmax};
  for (u32 axis = 0; axis < 3; ++axis) {
    const Float4 p = node.planes[axis];
    const float inverse = s.inverse[axis], near = s.near[axis], far = s.far[axis];
    const bool ascending = bits_of(inverse) >> 31 == 0;
    entry[0] = later(entry[0], fma(ascending ? p.x : p.z, inverse, near));
    entry[1] = later(entry[1], fma(ascending ? p.y : p.w, inverse, near));
    exit[0] = earlier(exit[0], fma(ascending ? p.z : p.x, inverse, far));
    exit[1] = earlier(exit[1], fma(ascending ? p.w : p.y, inverse, far));
  }
  return {entry[0], entry[1], entry[0] <= exit[0], entry[1] <= exit[1]};
}

#else

/// Far distances are kept negated, so that one maximum narrows the near and the far side of both children.
struct PairSlabs {
  Float4 inverse[3], offset[3];
  HalfSwap swap[3];

  RW_FN PairSlabs(const Ray& ray, const Header& header) {
    const SlabRay s = slab_ray(ray, header.centre, header.half_extent);
    set(0, s.inverse.x, s.near.x, s.far.x);
    set(1, s.inverse.y, s.near.y, s.far.y);
    set(2, s.inverse.z, s.near.z, s.far.z);
  }

 private:
  RW_FN void set(u32 axis, float inv, float near, float far) {
    inverse[axis] = Float4{inv, inv, -inv, -inv};
    offset[axis] = Float4{near, near, -far, -far};
    swap[axis] = half_swap(inv < 0.0f);
  }
};

struct PairLimits {
  Float4 values;
  RW_FN PairLimits(float tmin, float tmax) : values{tmin, tmin, -tmax, -tmax} {}
};

RW_FN PairEntries entries_of(const PairSlabs& s, const Node& node, const PairLimits& limits) {
  const Float4 x = fma(swapped(node.planes[0], s.swap[0]), s.inverse[0], s.offset[0]);
  const Float4 y = fma(swapped(node.planes[1], s.swap[1]), s.inverse[1], s.offset[1]);
  const Float4 z = fma(swapped(node.planes[2], s.swap[2]), s.inverse[2], s.offset[2]);
  const Float4 t = larger(larger(x, y), larger(z, limits.values));
  const u32 ordered = ordered_pairs(t);
  return {t[0], t[1], (ordered & 1u) != 0, (ordered & 2u) != 0};
}

#endif

}  // namespace raywalk::bvh
