// Host only: the binary BVH's builder: top-down, binned surface area heuristic over centroids.
// Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007.
#pragma once
#include "kernels/accel/kind.h"

namespace raywalk::bvh {

/// Rows of RW_NODE_FORMATS.
enum class NodeFormat : u32 { floats, halves, bytes };

struct Config {
  u32 bins = 32;  // candidate planes an axis, at most kMaxBins
  u32 max_leaf = 4;
  float traversal_cost = 1.0f;     // of a step through an inner node
  float intersection_cost = 1.0f;  // of a triangle test
  TriangleRecords triangles = TriangleRecords::corners;
  NodeFormat nodes = NodeFormat::floats;
};

/// Leaves non-finite triangles out. The blob is the same, byte for byte, whatever the number of threads.
/// Throws std::invalid_argument when the configuration is out of range, std::length_error above kMaxTriangles.
BuiltStructure build(SceneView scene, const Config& config);

const Kind& kind();

}  // namespace raywalk::bvh
