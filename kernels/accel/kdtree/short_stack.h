// kd-tree traversal with a short stack, restart and push-down: Horn et al., "Interactive k-D Tree GPU Raytracing",
// 2007. The stack is a parameter: it fixes what an entry holds.
#pragma once
#include "kernels/accel/kdtree/wide.h"

namespace raywalk::kdtree {

/// The ray is valid. `Stack` has push(enter, exit, node) for a far child and pop(enter, exit, node), which is called
/// with `enter` at the exit of the leaf just done and returns false when nothing is left.
///
/// Progress: a restart enters at the exit s of the last leaf. There that leaf was cut off by a split at exactly s,
/// whose far side alone is taken now (split <= enter), as it is at every split passed before. So the order of leaves
/// only advances, whatever is degenerate.
template <class Stack, class Query, class Counter>
RW_FN void traverse_short_stack(Stack& stack, const u8* blob, SceneView scene, const Ray& ray, Query& query,
                                Counter& counter) {
  const Header& tree = header_of<Header>(blob);
  LocalRay local;
  if (!enter(tree.frame, ray, local)) return;
  if (local.wide()) return traverse_wide(blob, scene, local, query, counter);

  const Node* nodes = data_of(blob, tree.nodes);
  const u32* references = data_of(blob, tree.references);
  const auto* records = records_by_id<Query, Header>(blob, scene);
  float enter_s = 0.0f, exit_s = local.exit;
  float limit = local.limit(query.tmax());
  u32 root = 0, index = 0;
  bool push_down = true;  // nothing but single children so far: a restart may begin here
  while (true) {
    Node node = nodes[index];
    counter.step();
    while (!node.leaf()) {
      const u32 axis = node.axis();
      const float split = (node.split() - local.o[axis]) * local.inverse[axis];
      const u32 down = local.d[axis] < 0.0f ? 1u : 0u;
      const u32 near = node.index() + down, far = node.index() + (down ^ 1u);
      if (split <= enter_s) {
        index = far;
      } else if (split >= exit_s) {
        index = near;
      } else {
        stack.push(split, exit_s, far);
        index = near;
        exit_s = split;
        push_down = false;
      }
      if (push_down) root = index;
      node = nodes[index];
      counter.step();
    }
    if (node.count() != 0) {
      if (test_leaf(node, references, records, query, counter)) return;
      limit = local.limit(query.tmax());
    }
    if (limit < exit_s) return;
    enter_s = exit_s;
    if (!stack.pop(enter_s, exit_s, index)) {
      if (!(exit_s < local.exit)) return;
      exit_s = local.exit;
      index = root;
      push_down = true;
    }
  }
}

}  // namespace raywalk::kdtree
