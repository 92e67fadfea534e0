// The binary BVH in memory: 64-byte nodes that hold both children's boxes, and triangles copied in leaf order.
#pragma once
#include "kernels/accel/records.h"
#include "kernels/float4.h"
#include "kernels/scene_view.h"

namespace raywalk::bvh {

/// A child, or the root, in one word: an inner node's index, or a leaf's first triangle and triangle count.
using Child = u32;
constexpr u32 kLeafBit = 1u << 31;
constexpr u32 kLeafCountShift = 28;
constexpr u32 kMaxLeaf = 8;
constexpr u32 kMaxTriangles = 1u << kLeafCountShift;
/// No leaf lies deeper than this below the root, so a stack of this many entries never overflows.
constexpr u32 kMaxDepth = 64;

RW_FN bool is_leaf(Child c) {
  return (c & kLeafBit) != 0;
}
RW_FN Child leaf(u32 first, u32 count) {
  return kLeafBit | (count - 1) << kLeafCountShift | first;
}
RW_FN u32 leaf_first(Child c) {
  return c & (kMaxTriangles - 1);
}
RW_FN u32 leaf_count(Child c) {
  return (c >> kLeafCountShift & (kMaxLeaf - 1)) + 1;
}

/// One axis a row: low planes of the left and the right child, then their high planes; relative to the header's centre,
/// rounded outward.
struct alignas(64) Node {
  Float4 planes[3];
  Child child[2];
  u32 pad[2];
};
static_assert(sizeof(Node) == 64);

struct alignas(64) Header {
  Slice<Node> nodes;
  u64 triangles_offset;  // of the records in leaf order
  u64 triangle_count;    // finite ones only; 0: nothing to traverse
  Box bounds;
  Vec3 centre;
  float half_extent;  // the largest of the three, seen from the centre
  Child root;
  u32 depth;  // of the deepest leaf; 0 when the root is a leaf

  /// Record is Corners or Transform, whichever the structure holds.
  template <class Record>
  RW_FN Slice<Record> triangles() const {
    return {triangles_offset, triangle_count};
  }
};

}  // namespace raywalk::bvh
