// Two triangles in the boxes that the BVH's builder gives them, and rays that aim at what is hard about both.
#pragma once
#include "kernels/accel/bvh/build.h"
#include "kernels/accel/bvh/layout.h"
#include "server/accuracy/cases/meshes.h"

namespace raywalk::at_scale {

/// A tree of one node in each of its formats.
struct BoxedPair {
  BuiltStructure built;
  Corners triangles[2];  // of the left and the right child
  float sizes[2];
  bvh::HalfNode half;
  bvh::ByteNode byte;

  const bvh::Header& header() const { return header_of<bvh::Header>(built.blob.data()); }
  const bvh::Node& node() const { return data_of(built.blob.data(), header().nodes<bvh::Node>())[0]; }
};

/// Sizes of 1e-6 to 1e6 and up to 1e6 of them away from the origin, in any shape down to slivers and flat ones; the
/// second triangle may be far off, or of another size. Both have an area.
BoxedPair random_pair(accuracy::Random& random);

/// A ray at an edge, vertex or inner point of that triangle, or at a face, edge or corner of its box: in any
/// direction, along an axis, or nearly so; from nearby or far away. Some also look behind their origin.
Ray random_ray(const BoxedPair& pair, u32 side, accuracy::Random& random);

}  // namespace raywalk::at_scale
