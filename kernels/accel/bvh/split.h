// Host only: where the builder divides a range of triangles in two.
#pragma once
#include <span>

#include "kernels/accel/bvh/build.h"

namespace raywalk::bvh {

constexpr u32 kMaxBins = 64;

/// A triangle's bounds while the tree is built.
struct Reference {
  Vec3 lo;
  u32 id;
  Vec3 hi;
  u32 pad;

  Vec3 centroid() const { return 0.5f * lo + 0.5f * hi; }
};

/// A division of a range: the first `left_count` references, after reordering, form the left child.
struct Division {
  u32 left_count;
  Box left, right;
};

/// Reorders `range`, whose bounds are `box`, and divides it. A range of at most `config.max_leaf` that is cheapest as a
/// leaf gives left_count 0. Both parts hold at least one reference otherwise.
Division divide_by_sah(std::span<Reference> range, const Box& box, const Config& config);

/// Two halves along the longest axis of the centroids; equal centroids are told apart by id.
Division divide_in_half(std::span<Reference> range);

/// Union of the bounds; in parallel when there are many.
Box bounds_of(std::span<const Reference> range);

}  // namespace raywalk::bvh
