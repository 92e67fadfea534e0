// kd-tree as stored: 8-byte nodes after Wald et al., "Interactive Rendering with Coherent Ray Tracing", 2001.
#pragma once
#include "kernels/accel/padded_frame.h"
#include "kernels/accel/records.h"
#include "kernels/blob.h"

namespace raywalk::kdtree {

/// Inner node: split axis and position, and the left child's index (the right child follows it).
/// Leaf: the run of its references.
struct Node {
  static constexpr u32 kLeaf = 3;
  static constexpr u32 kMaxIndex = (1u << 30) - 1;
  u32 tag;    // low two bits: axis, or kLeaf; the others: index of the left child or of the first reference
  u32 value;  // bits of the split position in the frame, or the number of references

  RW_FN bool leaf() const { return (tag & 3u) == kLeaf; }
  RW_FN u32 axis() const { return tag & 3u; }
  RW_FN u32 index() const { return tag >> 2; }
  RW_FN float split() const { return float_of(value); }
  RW_FN u32 count() const { return value; }
};

/// Levels below the root never exceed this: the wide traversal keeps one bit a level.
constexpr u32 kMaxDepth = 63;

struct Header {
  PaddedFrame frame;            // the root's cell is [-half, half]
  Slice<Node> nodes;            // the root first
  Slice<u32> references;        // triangle ids, ascending in each leaf
  Slice<Transform> transforms;  // by id; none unless they were asked for
};

/// Tests one leaf's triangles. True when the traversal is finished.
template <class Query, class Counter>
RW_FN bool test_leaf(Node leaf, const u32* references, const typename Query::Record* records, Query& query,
                     Counter& counter) {
  const u32* reference = references + leaf.index();
  for (const u32* end = reference + leaf.count(); reference != end; ++reference) {
    counter.test();
    if (query.test(records[*reference])) return true;
  }
  return false;
}

}  // namespace raywalk::kdtree
