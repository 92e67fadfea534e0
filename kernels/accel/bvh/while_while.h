// One ray a thread: inner nodes until a leaf is reached, near child first, then the leaf's triangles.
// Aila and Laine, "Understanding the Efficiency of Ray Traversal on GPUs", HPG 2009.
#pragma once
#include "kernels/accel/bvh/pair.h"
#include "kernels/query.h"

namespace raywalk::bvh::while_while {

struct Waiting {
  Child child;
  float entry;
};

/// `blob` is a BVH of the scene's triangles. The ray is valid.
template <class Query, class Counter>
RW_FN void traverse(const u8* blob, SceneView /*scene*/, const Ray& ray, Query& query, Counter& counter) {
  const Header& header = header_of<Header>(blob);
  if (header.triangle_count == 0) return;
  using NodeT = typename Query::Knobs::Nodes::Node;
  const NodeT* nodes = data_of(blob, header.nodes<NodeT>());
  const auto* triangles = data_of(blob, header.triangles<typename Query::Record>());
  const PairSlabs<typename Query::Knobs::Slab> slabs(ray, header);
  PairLimits limits{query.tmin, query.tmax()};
  Waiting stack[kMaxDepth];
  u32 waiting = 0;
  Child at = header.root;
  for (;;) {
    bool missed = false;
    while (!is_leaf(at)) {
      counter.step();
      const NodeT& node = nodes[at];
      const Child left = node.child[0], right = node.child[1];
      const PairEntries t = entries_of(slabs, node, header.unit, limits);
      if (t.meets_left && t.meets_right) {
        // Near first pays for any hit as well: an occluder is met sooner.
        const bool left_first = t.left <= t.right;
        stack[waiting++] = {left_first ? right : left, left_first ? t.right : t.left};
        at = left_first ? left : right;
      } else if (t.meets_left || t.meets_right) {
        at = t.meets_left ? left : right;
      } else {
        missed = true;
        break;
      }
    }
    if (!missed) {
      const u32 first = leaf_first(at), end = first + leaf_count(at);
      for (u32 i = first; i < end; ++i) {
        counter.test();
        if (query.test(triangles[i])) return;
      }
      if constexpr (!Query::kAny) limits = PairLimits{query.tmin, query.tmax()};
    }
    // A subtree at exactly the best distance may still hold a lower id.
    do {
      if (waiting == 0) return;
      --waiting;
    } while (stack[waiting].entry > query.tmax());
    at = stack[waiting].child;
  }
}

}  // namespace raywalk::bvh::while_while
