// kd-tree traversal of a wide ray (see padded_frame.h): a beam overlaps both children near a split, so leaves are told
// apart by their path, not by distance. Stackless, restarting from the root after each leaf with a trail of one bit a
// level; after Laine, "Restart Trail for Stackless BVH Traversal", 2010.
#pragma once
#include "kernels/accel/kdtree/layout.h"

namespace raywalk::kdtree {

template <class Query, class Counter>
RW_FN void traverse_wide(const u8* blob, SceneView scene, const LocalRay& ray, Query& query, Counter& counter) {
  const Header& tree = header_of<Header>(blob);
  const Node* nodes = data_of(blob, tree.nodes);
  const u32* references = data_of(blob, tree.references);
  const auto* records = records_by_id<Query, Header>(blob, scene);
  u64 trail = 0;  // bit k: at level k of the present path the near child is done
  while (true) {
    Node node = nodes[0];
    float enter_s = 0.0f, exit_s = ray.exit;
    u64 level = 1, choice = 0;  // choice: the deepest level at which the far child is still to be done
    bool inside = true;
    counter.step();
    while (inside && !node.leaf()) {
      const u32 axis = node.axis();
      const bool down = ray.d[axis] < 0.0f;
      const float reach = down ? -ray.radius : ray.radius;
      const float near_exit = (node.split() + reach - ray.o[axis]) * ray.inverse[axis];
      const float far_enter = (node.split() - reach - ray.o[axis]) * ray.inverse[axis];
      const bool near = near_exit >= enter_s, far = far_enter <= exit_s;
      bool go_far = !near;
      if (near && far) {
        go_far = (trail & level) != 0;
        if (!go_far) choice = level;
      }
      if (go_far) {
        enter_s = larger(far_enter, enter_s);
        inside = far && enter_s <= ray.limit(query.tmax());
      } else {
        exit_s = smaller(near_exit, exit_s);
      }
      node = nodes[node.index() + (go_far != down ? 1u : 0u)];
      level <<= 1;
      counter.step();
    }
    if (inside && test_leaf(node, references, records, query, counter)) return;
    if (choice == 0) return;
    trail = (trail & (choice - 1)) | choice;
  }
}

}  // namespace raywalk::kdtree
