// The binary BVH in memory: nodes that hold both children's boxes, and triangles copied in leaf order.
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
/// rounded outward. All kinds of nodes give their rows as floats by `row`; `unit` is the header's.
struct alignas(64) Node {
  Float4 planes[3];
  Child child[2];
  u32 pad[2];

  RW_FN Float4 row(u32 axis, float /*unit*/) const { return planes[axis]; }
};
static_assert(sizeof(Node) == 64);

/// Planes as multiples of the header's unit in half precision. What `row` gives contains the box in exact arithmetic.
struct alignas(32) HalfNode {
  struct alignas(8) Halves {
    u32 low, high;  // both low planes, both high planes
  };
  Halves planes[3];
  Child child[2];

  RW_FN Float4 row(u32 axis, float unit) const {
    const Halves halves = planes[axis];
    return floats_of_halves(halves.low, halves.high) * all_of(unit);
  }
};
static_assert(sizeof(HalfNode) == 32);

/// Planes as numbers of steps from an origin, one byte each. A step is a power of two: the low byte of the origin's
/// bits is its exponent as floats have it. What `row` gives, with its one rounding, contains the box in exact
/// arithmetic.
struct alignas(32) ByteNode {
  u32 origin[3];  // bits of floats
  u32 planes[3];  // low planes of the left and the right child, then their high planes, from the lowest byte on
  Child child[2];

  RW_FN Float4 row(u32 axis, float /*unit*/) const {
    const u32 bits = origin[axis];
    return fma(floats_of_bytes(planes[axis]), all_of(float_of((bits & 255u) << 23)), all_of(float_of(bits)));
  }
};
static_assert(sizeof(ByteNode) == 32);

struct alignas(64) Header {
  u64 nodes_offset;
  u64 node_count;
  u64 triangles_offset;  // of the records in leaf order
  u64 triangle_count;    // finite ones only; 0: nothing to traverse
  Box bounds;
  Vec3 centre;
  float half_extent;  // the largest of the three, seen from the centre
  Child root;
  u32 depth;   // of the deepest leaf; 0 when the root is a leaf
  u32 format;  // of the nodes: a row of RW_NODE_FORMATS
  float unit;  // of half nodes, a power of two

  /// Node, HalfNode or ByteNode, as `format` says.
  template <class NodeT>
  RW_FN Slice<NodeT> nodes() const {
    return {nodes_offset, node_count};
  }
  /// Record is Corners or Transform, whichever the structure holds.
  template <class Record>
  RW_FN Slice<Record> triangles() const {
    return {triangles_offset, triangle_count};
  }
};

}  // namespace raywalk::bvh

namespace raywalk {

struct FloatNodes {
  using Node = bvh::Node;
};
struct HalfNodes {
  using Node = bvh::HalfNode;
};
struct ByteNodes {
  using Node = bvh::ByteNode;
};

}  // namespace raywalk
