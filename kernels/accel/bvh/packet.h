// A packet of rays walks the tree together: one shared stack of node indices, children chosen by vote, the order of
// both children by majority. Guenther, Popov, Seidel and Slusallek, "Realtime Ray Tracing on GPU with BVH-based Packet
// Traversal", RT 2007, with the study's change: a ray that needs neither child has no say in the order.
#pragma once
#include "kernels/accel/bvh/layout.h"
#include "kernels/accel/slab.h"
#include "kernels/lanes.h"
#include "kernels/query.h"

namespace raywalk::bvh::packet {

/// The slab constants of a thread's lanes, as arrays. Low and high planes instead of near and far ones, so that lanes
/// of different signs run through the same instructions: near = smaller(low, high).
template <class Slab, u32 N>
struct Slabs {
  float inverse_low[3][N], inverse_high[3][N], low[3][N], high[3][N];
  float tmin[N], tmax[N];  // tmax below tmin: the lane has finished

  RW_FN void set(u32 lane, const Ray& ray, const Header& header) {
    const SlabRay s = slab_ray<Slab>(ray, header.centre, header.half_extent);
    for (u32 axis = 0; axis < 3; ++axis) {
      const bool ascending = bits_of(s.inverse[axis]) >> 31 == 0;
      inverse_low[axis][lane] = ascending ? s.inverse[axis] : s.inverse_far[axis];
      inverse_high[axis][lane] = ascending ? s.inverse_far[axis] : s.inverse[axis];
      low[axis][lane] = ascending ? s.near[axis] : s.far[axis];
      high[axis][lane] = ascending ? s.far[axis] : s.near[axis];
    }
  }
};

/// What lanes want of a node, packed so that one sum over the lanes tells it of all: how many want the left child, how
/// many the right one, and the order as the sum of -1 (left first), 0 and +1 (right first) of each lane.
struct Votes {
  static constexpr u32 kRight = 8, kOrder = 16;  // shifts; a field holds up to 2 * kMaxLanes
  static constexpr u32 kMaxLanes = 127;
  u32 sum;

  RW_FN static u32 of_lane(bool left, bool right, i32 order) {
    return (left ? 1u : 0u) | (right ? 1u : 0u) << kRight | static_cast<u32>(order + 1) << kOrder;
  }
  RW_FN bool left() const { return (sum & 255u) != 0; }
  RW_FN bool right() const { return (sum >> kRight & 255u) != 0; }
  RW_FN bool right_first(u32 lanes) const { return sum >> kOrder > lanes; }
};

/// The votes of a thread's lanes on a node. A lane that needs neither child has no say in the order.
template <class Slab, u32 N, class NodeT>
RW_FN void choose(const Slabs<Slab, N>& s, const NodeT& node, float unit, u32* votes) {
  const Float4 rows[3] = {node.row(0, unit), node.row(1, unit), node.row(2, unit)};
  float entry[2][N], exit[2][N];
  for (u32 side = 0; side < 2; ++side) {
    for (u32 i = 0; i < N; ++i) {
      entry[side][i] = s.tmin[i];
      exit[side][i] = s.tmax[i];
    }
    for (u32 axis = 0; axis < 3; ++axis) {
      const float lo = rows[axis][side], hi = rows[axis][side + 2];
      for (u32 i = 0; i < N; ++i) {
        const float a = crossing<Slab>(lo, s.inverse_low[axis][i], s.low[axis][i]);
        const float b = crossing<Slab>(hi, s.inverse_high[axis][i], s.high[axis][i]);
        if constexpr (Slab::kInfinities) {  // a NaN is dropped only if it is known which side it belongs to
          const bool ascending = s.inverse_low[axis][i] > 0.0f;
          entry[side][i] = larger(ascending ? a : b, entry[side][i]);
          exit[side][i] = smaller(ascending ? b : a, exit[side][i]);
        } else {
          entry[side][i] = larger(smaller(a, b), entry[side][i]);
          exit[side][i] = smaller(larger(a, b), exit[side][i]);
        }
      }
    }
  }
  for (u32 i = 0; i < N; ++i) {
    const bool left = entry[0][i] <= widened<Slab>(exit[0][i]), right = entry[1][i] <= widened<Slab>(exit[1][i]);
    const i32 nearer = (entry[1][i] < entry[0][i] ? 1 : 0) - (entry[0][i] < entry[1][i] ? 1 : 0);
    const i32 alone = (right ? 1 : 0) - (left ? 1 : 0);
    votes[i] = Votes::of_lane(left, right, left && right ? nearer : alone);
  }
}

/// Arrays of LanesT::kLocal; lanes that are not active are neither read nor written and count nothing. `blob` is a BVH
/// of the scene's triangles. Active rays are valid.
template <class LanesT, class Query, class Counter>
RW_FN void traverse(const u8* blob, SceneView /*scene*/, const Ray* rays, const bool* active, Query* queries,
                    Counter* counters) {
  constexpr u32 kLocal = LanesT::kLocal;
  static_assert(LanesT::kCount <= Votes::kMaxLanes);
  const Header& header = header_of<Header>(blob);
  if (header.triangle_count == 0) return;
  using NodeT = typename Query::Knobs::Nodes::Node;
  const NodeT* nodes = data_of(blob, header.nodes<NodeT>());
  const auto* triangles = data_of(blob, header.triangles<typename Query::Record>());

  Slabs<typename Query::Knobs::Slab, kLocal> slabs = {};
  bool going[kLocal];
  for (u32 i = 0; i < kLocal; ++i) {
    going[i] = active[i];
    slabs.tmin[i] = 0.0f;
    slabs.tmax[i] = -1.0f;
    if (!active[i]) continue;
    slabs.set(i, rays[i], header);
    slabs.tmin[i] = queries[i].tmin;
    slabs.tmax[i] = queries[i].tmax();
  }
  if (!LanesT::any(going)) return;

  RW_SHARED Child stacks[LanesT::kGroups][kMaxDepth];
  Child* stack = stacks[LanesT::group()];
  u32 waiting = 0;  // the same in all lanes
  Child at = header.root;
  for (;;) {
    bool descends = false;
    if (is_leaf(at)) {
      const u32 first = leaf_first(at), end = first + leaf_count(at);
      for (u32 t = first; t < end; ++t) {
        for (u32 i = 0; i < kLocal; ++i) {
          if (!going[i]) continue;
          counters[i].test();
          if (queries[i].test(triangles[t])) {
            going[i] = false;
            slabs.tmax[i] = -1.0f;
            slabs.tmin[i] = 0.0f;
          }
        }
      }
      if constexpr (Query::kAny) {
        if (!LanesT::any(going)) return;
      } else {
        for (u32 i = 0; i < kLocal; ++i) {
          if (going[i]) slabs.tmax[i] = queries[i].tmax();
        }
      }
    } else {
      const NodeT& node = nodes[at];
      u32 lane_votes[kLocal];
      choose(slabs, node, header.unit, lane_votes);
      for (u32 i = 0; i < kLocal; ++i) {
        if (going[i]) counters[i].step();
      }
      const Votes votes{LanesT::sum(lane_votes)};
      descends = votes.left() || votes.right();
      if (votes.left() && votes.right()) {
        const u32 nearer = votes.right_first(LanesT::kCount) ? 1u : 0u;
        if (LanesT::leads()) stack[waiting] = node.child[nearer ^ 1u];
        ++waiting;
        at = node.child[nearer];
      } else if (descends) {
        at = node.child[votes.right() ? 1 : 0];
      }
    }
    if (descends) continue;
    if (waiting == 0) return;
    LanesT::barrier();  // an entry may have been written since the last collective
    at = stack[--waiting];
    LanesT::barrier();  // before the place is written again
  }
}

}  // namespace raywalk::bvh::packet
