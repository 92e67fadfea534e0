// Host only: nodes of lower precision. Every box that they give contains the box of the precise node, exactly.
#pragma once
#include <span>

#include "kernels/accel/bvh/layout.h"

namespace raywalk::bvh {

/// The unit of half nodes: the scene's half extent is some 2^14 of it.
float unit_of_halves(float half_extent);

HalfNode compressed_to_halves(const Node& node, float unit);
/// Throws std::invalid_argument for a box at the very end of the floats, above 3.4e38.
ByteNode compressed_to_bytes(const Node& node);

/// All nodes; nothing when there is no room for any.
void compress(std::span<const Node> nodes, float unit, std::span<HalfNode> to);
void compress(std::span<const Node> nodes, std::span<ByteNode> to);

}  // namespace raywalk::bvh
