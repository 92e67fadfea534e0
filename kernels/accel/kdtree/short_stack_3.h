// kd-tree traversal `kdtree/short-stack-3` (the study's kdt-3): an entry is (enter, exit, node).
#pragma once
#include "kernels/accel/kdtree/ring.h"
#include "kernels/accel/kdtree/short_stack.h"

namespace raywalk::kdtree::short_stack_3 {

struct Stack {
  Ring<3> ring;
  RW_FN explicit Stack(u32 entries) : ring(entries) {}
  RW_FN void push(float enter, float exit, u32 node) {
    const u32 entry[] = {bits_of(enter), bits_of(exit), node};
    ring.push(entry);
  }
  RW_FN bool pop(float& enter, float& exit, u32& node) {
    u32 entry[3];
    if (!ring.pop(entry)) return false;
    enter = float_of(entry[0]);
    exit = float_of(entry[1]);
    node = entry[2];
    return true;
  }
};

/// The ray is valid.
template <class Query, class Counter>
RW_FN void traverse(const u8* blob, SceneView scene, const Ray& ray, Query& query, Counter& counter) {
  Stack stack(query.stack_entries);
  traverse_short_stack(stack, blob, scene, ray, query, counter);
}

}  // namespace raywalk::kdtree::short_stack_3
