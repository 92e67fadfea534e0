// kd-tree traversal `kdtree/short-stack-2` (the study's kdt-2): an entry is (exit, node), for a far child is entered
// where the leaf just done was left.
#pragma once
#include "kernels/accel/kdtree/short_stack.h"

namespace raywalk::kdtree::short_stack_2 {

struct Entry {
  float exit;
  u32 node;
};

struct Stack {
  Ring<Entry> ring;
  RW_FN void push(float /*enter*/, float exit, u32 node) { ring.push({exit, node}); }
  RW_FN bool pop(float& /*enter*/, float& exit, u32& node) {
    Entry entry;
    if (!ring.pop(entry)) return false;
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

}  // namespace raywalk::kdtree::short_stack_2
