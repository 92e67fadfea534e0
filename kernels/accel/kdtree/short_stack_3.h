// kd-tree traversal `kdtree/short-stack-3` (the study's kdt-3): an entry is (enter, exit, node).
#pragma once
#include "kernels/accel/kdtree/short_stack.h"

namespace raywalk::kdtree::short_stack_3 {

struct Entry {
  float enter, exit;
  u32 node;
};

struct Stack {
  Ring<Entry> ring;
  RW_FN void push(float enter, float exit, u32 node) { ring.push({enter, exit, node}); }
  RW_FN bool pop(float& enter, float& exit, u32& node) {
    Entry entry;
    if (!ring.pop(entry)) return false;
    enter = entry.enter;
    exit = entry.exit;
    node = entry.node;
    return true;
  }
};

/// The ray is valid.
template <class Query, class Counter>
RW_FN void traverse(const u8* blob, SceneView scene, const Ray& ray, Query& query, Counter& counter) {
  Stack stack;
  traverse_short_stack(stack, blob, scene, ray, query, counter);
}

}  // namespace raywalk::kdtree::short_stack_3
