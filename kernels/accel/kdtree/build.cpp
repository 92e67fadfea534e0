// Builds the kd-tree top down: large nodes fork, small ones become chunks built by one thread, and at the end the
// chunks are laid out in one blob, always in the same order.
#include "kernels/accel/kdtree/build.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "kernels/accel/build_records.h"
#include "kernels/accel/kdtree/layout.h"
#include "kernels/accel/kdtree/work.h"

namespace raywalk::kdtree {
namespace {

/// A finished subtree with its own numbering; its root is node 0.
struct Chunk {
  std::vector<Node> nodes;
  std::vector<u32> references;
  double cost = 0;  // times area
  u64 leaves = 0;
  u32 depth = 0;
  u64 first_node = 0, first_reference = 0;  // in the blob; first_node is where node 1 goes
};

/// A node of the tree's top: inner, or the root of a chunk.
struct Branch {
  Split split;
  std::unique_ptr<Branch> children[2];
  Chunk chunk;
};

u32 inner_tag(const Split& split, u64 left_child) {
  if (left_child + 1 > Node::kMaxIndex) throw std::length_error("kdtree: more than 2^30 nodes");
  return static_cast<u32>(left_child << 2) | static_cast<u32>(split.axis);
}
u32 leaf_tag(u64 first_reference) {
  if (first_reference > Node::kMaxIndex) throw std::length_error("kdtree: more than 2^30 references");
  return static_cast<u32>(first_reference << 2) | Node::kLeaf;
}

struct Limits {
  const Source& source;
  const Config& config;
  u32 max_depth;

  /// Whether splitting is cheaper than a leaf.
  template <class Work>
  bool find_split(const Work& work, const Cell& cell, u32 depth, Split& split) const {
    if (depth >= max_depth || work.size() == 0) return false;
    split = work.find_split(config, cell);
    return split.cost < config.intersection_cost * work.size();
  }
};

template <class Work>
void build_chunk(const Limits& limits, Work work, const Cell& cell, u32 depth, u32 slot, Chunk& chunk) {
  Split split;
  chunk.depth = std::max(chunk.depth, depth);
  if (!limits.find_split(work, cell, depth, split)) {
    chunk.nodes[slot] = {leaf_tag(chunk.references.size()), work.size()};
    for (const Part& part : work.parts()) chunk.references.push_back(part.id);
    chunk.cost += limits.config.intersection_cost * work.size() * cell.half_area();
    ++chunk.leaves;
    return;
  }
  chunk.cost += limits.config.traversal_cost * cell.half_area();
  const u32 left = static_cast<u32>(chunk.nodes.size());
  chunk.nodes[slot] = {inner_tag(split, left), bits_of(split.position)};
  chunk.nodes.resize(left + 2);
  Work halves[2];
  work.split(limits.source, cell, split, halves);
  for (const int side : {0, 1}) {
    build_chunk(limits, std::move(halves[side]), child_of(cell, split, side), depth + 1, left + side, chunk);
  }
}

template <class Work>
void build_branch(const Limits& limits, Work work, const Cell& cell, u32 depth, Branch& branch) {
  if (work.size() < kParallelSize || !limits.find_split(work, cell, depth, branch.split)) {
    branch.chunk.nodes.resize(1);
    build_chunk(limits, std::move(work), cell, depth, 0, branch.chunk);
    branch.chunk.nodes.shrink_to_fit();
    branch.chunk.references.shrink_to_fit();
    return;
  }
  branch.chunk.cost = limits.config.traversal_cost * cell.half_area();
  Work halves[2];
  work.split(limits.source, cell, branch.split, halves);
  const auto descend = [&](int side) {
    branch.children[side] = std::make_unique<Branch>();
    build_branch(limits, std::move(halves[side]), child_of(cell, branch.split, side), depth + 1,
                 *branch.children[side]);
  };
  tbb::parallel_invoke([&] { descend(0); }, [&] { descend(1); });
}

/// Numbers the nodes and references of all chunks.
struct Layout {
  struct Placed {
    Branch* branch;
    u64 slot;
    u64 left;  // of an inner branch
  };
  std::vector<Placed> placed;
  u64 nodes = 1, references = 0, leaves = 0;
  double cost = 0;
  u32 depth = 0;

  void place(Branch& branch, u64 slot) {
    Chunk& chunk = branch.chunk;
    cost += chunk.cost;
    placed.push_back({&branch, slot, nodes});
    if (branch.children[0]) {
      const u64 left = nodes;
      nodes += 2;
      place(*branch.children[0], left);
      place(*branch.children[1], left + 1);
      return;
    }
    chunk.first_node = nodes;
    chunk.first_reference = references;
    nodes += chunk.nodes.size() - 1;
    references += chunk.references.size();
    leaves += chunk.leaves;
    depth = std::max(depth, chunk.depth);
  }
};

/// Moves a chunk's nodes and references to their place in the blob.
void copy_chunk(Chunk& chunk, u64 slot, std::span<Node> nodes, std::span<u32> references) {
  for (size_t i = 0; i < chunk.nodes.size(); ++i) {
    Node node = chunk.nodes[i];
    if (node.leaf()) {
      node.tag = leaf_tag(chunk.first_reference + node.index());
    } else {
      const Split split{.cost = 0, .axis = static_cast<int>(node.axis()), .position = node.split()};
      node.tag = inner_tag(split, chunk.first_node + node.index() - 1);
    }
    nodes[i == 0 ? slot : chunk.first_node + i - 1] = node;
  }
  std::copy(chunk.references.begin(), chunk.references.end(), &references[0] + chunk.first_reference);
}

std::vector<Part> parts_of(SceneView scene, const PaddedFrame& frame) {
  std::vector<Part> parts;
  parts.reserve(scene.triangle_count());
  for (u32 i = 0; i < scene.triangle_count(); ++i) {
    const Corners& triangle = scene.corners()[i];
    if (!is_finite(triangle)) continue;
    const Box box = padded_bounds(frame, triangle);
    parts.push_back({{{box.lo.x, box.lo.y, box.lo.z}, {box.hi.x, box.hi.y, box.hi.z}}, i});
  }
  return parts;
}

}  // namespace

BuiltStructure build(SceneView scene, const Config& config) {
  const auto start = std::chrono::steady_clock::now();
  Header header{};
  header.frame = padded_frame(scene.header().bounds);
  const Source source{scene.corners(), header.frame};
  const Vec3 half = header.frame.half;
  const Cell cell{{-half.x, -half.y, -half.z}, {half.x, half.y, half.z}};
  std::vector<Part> parts = parts_of(scene, header.frame);
  const double deepest = 8.0 + 1.3 * std::log2(static_cast<double>(std::max<size_t>(parts.size(), 1)));
  const Limits limits{source, config, std::min(static_cast<u32>(deepest), kMaxDepth)};
  Branch top;
  if (config.sah == Sah::kExact) {
    build_branch(limits, ExactWork(std::move(parts)), cell, 0, top);
  } else {
    build_branch(limits, SampledWork(std::move(parts)), cell, 0, top);
  }

  Layout layout;
  layout.place(top, 0);
  BlobPlan plan(sizeof(Header));
  header.nodes = plan.add<Node>(layout.nodes);
  header.references = plan.add<u32>(layout.references);
  header.transforms = plan.add<Transform>(config.triangles == TriangleRecords::transforms ? scene.triangle_count() : 0);
  BuiltStructure result{plan.allocate(), {}, {config.triangles}};
  std::memcpy(result.blob.data(), &header, sizeof(Header));
  const std::span<Node> nodes = slice_of(result.blob, header.nodes);
  const std::span<u32> references = slice_of(result.blob, header.references);
  tbb::parallel_for(size_t{0}, layout.placed.size(), [&](size_t i) {
    const auto& [branch, slot, left] = layout.placed[i];
    if (branch->children[0]) {
      nodes[slot] = {inner_tag(branch->split, left), bits_of(branch->split.position)};
    } else {
      copy_chunk(branch->chunk, slot, nodes, references);
      branch->chunk = {};
    }
  });
  write_transforms(scene, slice_of(result.blob, header.transforms));

  BuildStats& stats = result.stats;
  stats.nodes = layout.nodes;
  stats.leaves = layout.leaves;
  stats.references = layout.references;
  stats.size_bytes = result.blob.size_bytes();
  stats.max_depth = layout.depth;
  stats.sah_cost = layout.cost / cell.half_area();
  stats.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace raywalk::kdtree
