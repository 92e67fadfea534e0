// One ray against the boxes of both children of a node at once.
#pragma once
#include "kernels/accel/bvh/layout.h"
#include "kernels/accel/slab.h"

namespace raywalk::bvh {

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

RW_FN Float4 limits_of(float tmin, float tmax) {
  return Float4{tmin, tmin, -tmax, -tmax};
}

/// Entry distances of left and right, then the negated exits; child i is entered when bit i of `ordered_pairs` is set.
RW_FN Float4 distances(const PairSlabs& s, const Node& node, Float4 limits) {
  const Float4 x = fma(swapped(node.planes[0], s.swap[0]), s.inverse[0], s.offset[0]);
  const Float4 y = fma(swapped(node.planes[1], s.swap[1]), s.inverse[1], s.offset[1]);
  const Float4 z = fma(swapped(node.planes[2], s.swap[2]), s.inverse[2], s.offset[2]);
  return larger(larger(x, y), larger(z, limits));
}

}  // namespace raywalk::bvh
