// Host only: builds the kd-tree.
#pragma once
#include "kernels/accel/kind.h"

namespace raywalk::kdtree {

/// Where split planes come from: every bound of the clipped triangles, or borders of bins filled from a sample.
enum class Sah { kExact, kSampled };

/// Costs are relative to each other; the defaults were measured on the CPU kernels.
struct Config {
  Sah sah = Sah::kExact;
  double traversal_cost = 1.5;
  double intersection_cost = 1.0;
  double empty_bonus = 0.2;  // a split that cuts off empty space costs this much less, as a fraction
  TriangleRecords triangles = TriangleRecords::corners;
};

/// Surface-area heuristic with perfect splits; depth at most 8 + 1.3 log2(triangles). Exact SAH takes O(n log n) time
/// (Wald and Havran, "On building fast kd-Trees for Ray Tracing, and on doing that in O(N log N)", 2006) and about 120
/// bytes a triangle beside the finished tree; sampled SAH bins after Shevtsov et al., "Highly Parallel Fast KD-tree
/// Construction for Interactive Ray Tracing of Dynamic Scenes", 2007. Throws std::length_error when the tree outgrows
/// its 30-bit indices.
BuiltStructure build(SceneView scene, const Config& config);

}  // namespace raywalk::kdtree
