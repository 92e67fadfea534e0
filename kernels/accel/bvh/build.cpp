// Host only: builds the tree over references, then packs nodes and triangles in depth-first order.
#include "kernels/accel/bvh/build.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "kernels/accel/bvh/compress.h"
#include "kernels/accel/bvh/layout.h"
#include "kernels/accel/bvh/split.h"
#include "kernels/accel/slab.h"

namespace raywalk::bvh {
namespace {

constexpr u32 kParallelCount = 4096;

/// An inner node in absolute coordinates. Its children, when they are inner nodes, are positions in the scratch array.
struct ScratchNode {
  Box box[2];
  Child child[2];
};

/// Halvings needed until `count` references fit into leaves.
u32 levels_of(u32 count, u32 max_leaf) {
  u32 levels = 0;
  for (; count > max_leaf; count = count - count / 2) ++levels;
  return levels;
}

/// A range of n references owns the n - 1 scratch places from `first` on, so that threads need not talk to each other.
class Tree {
 public:
  Tree(std::span<Reference> references, const Config& config)
      : references_(references),
        config_(config),
        scratch_(std::make_unique_for_overwrite<ScratchNode[]>(references.size())) {}

  Child grow(u32 first, u32 count, const Box& box, u32 depth) {
    const Division division = divided(first, count, box, depth);
    if (division.left_count == 0) return leaf(first, count);
    // Between the places of the left part, [first, middle - 1), and those of the right part, [middle, end - 1).
    const u32 middle = first + division.left_count, place = middle - 1;
    ScratchNode& node = scratch_[place];
    node.box[0] = division.left;
    node.box[1] = division.right;
    const auto left = [&] { node.child[0] = grow(first, division.left_count, division.left, depth + 1); };
    const auto right = [&] { node.child[1] = grow(middle, first + count - middle, division.right, depth + 1); };
    if (count >= kParallelCount) {
      tbb::parallel_invoke(left, right);
    } else {
      left();
      right();
    }
    return place;
  }
  const ScratchNode& operator[](Child c) const { return scratch_[c]; }

 private:
  Division divided(u32 first, u32 count, const Box& box, u32 depth) {
    if (count == 1) return {};
    const std::span<Reference> range = references_.subspan(first, count);
    // When only halving still reaches leaves within the depth limit, halve.
    if (levels_of(count, config_.max_leaf) + depth >= kMaxDepth) {
      return count <= config_.max_leaf ? Division{} : divide_in_half(range);
    }
    return divide_by_sah(range, box, config_);
  }

  std::span<Reference> references_;
  Config config_;
  std::unique_ptr<ScratchNode[]> scratch_;
};

float rounded_down(double a) {
  const float f = static_cast<float>(a);
  return static_cast<double>(f) > a ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float rounded_up(double a) {
  return -rounded_down(-a);
}

/// Numbers the nodes depth first, left before right, and makes their boxes relative to the centre.
class Packer {
 public:
  Packer(std::span<const Reference> references, const Tree& tree, const Config& config, const Box& bounds,
         BuildStats& stats)
      : references_(references),
        tree_(tree),
        config_(config),
        centre_(bounds.centre()),
        area_(bounds.area()),
        stats_(stats) {}

  u32 count(Child c, const Box& box, u32 depth) {
    // Scenes without area have no meaningful cost.
    const double share = area_ > 0.0 ? static_cast<double>(box.area()) / area_ : 0.0;
    ++stats_.nodes;
    if (is_leaf(c)) {
      ++stats_.leaves;
      stats_.references += leaf_count(c);
      stats_.max_depth = std::max(stats_.max_depth, depth);
      stats_.sah_cost += share * config_.intersection_cost * leaf_count(c);
      return 0;
    }
    stats_.sah_cost += share * config_.traversal_cost;
    const ScratchNode& node = tree_[c];
    const u32 left = count(node.child[0], node.box[0], depth + 1);
    return 1 + left + count(node.child[1], node.box[1], depth + 1);
  }

  /// The root of no triangles is a leaf that names one: there is none to look at.
  Child pack(Child c, std::span<Node> nodes) { return references_.empty() ? c : pack_padded(c, nodes).child; }

 private:
  struct Packed {
    Child child;
    double padding;  // of its box, for the largest of its triangles
  };

  Packed pack_padded(Child c, std::span<Node> nodes) {
    if (is_leaf(c)) return {c, padding_of(references_.subspan(leaf_first(c), leaf_count(c)))};
    const ScratchNode& from = tree_[c];
    const u32 index = used_++;
    const Packed left = pack_padded(from.child[0], nodes), right = pack_padded(from.child[1], nodes);
    Node& node = nodes[index];
    for (u32 axis = 0; axis < 3; ++axis) {
      const double centre = centre_[axis];
      node.planes[axis] = Float4{rounded_down(from.box[0].lo[axis] - centre - left.padding),
                                 rounded_down(from.box[1].lo[axis] - centre - right.padding),
                                 rounded_up(from.box[0].hi[axis] - centre + left.padding),
                                 rounded_up(from.box[1].hi[axis] - centre + right.padding)};
    }
    node.pad[0] = node.pad[1] = 0;
    node.child[0] = left.child;
    node.child[1] = right.child;
    return {index, std::max(left.padding, right.padding)};
  }

  static double padding_of(std::span<const Reference> triangles) {
    float extent = 0;
    for (const Reference& t : triangles) extent = std::max(extent, largest(t.hi - t.lo));
    return double{extent} * kTrianglePadding;
  }

  std::span<const Reference> references_;
  const Tree& tree_;
  const Config& config_;
  Vec3 centre_;
  double area_;
  BuildStats& stats_;
  u32 used_ = 0;
};

float half_extent_of(const Box& bounds) {
  const Vec3 c = bounds.centre();
  double extent = 0;
  for (u32 axis = 0; axis < 3; ++axis) {
    const double centre = c[axis];
    extent = std::max({extent, bounds.hi[axis] - centre, centre - bounds.lo[axis]});
  }
  return rounded_up(extent);
}

std::vector<Reference> finite_references(SceneView scene) {
  const Corners* corners = scene.corners();
  std::vector<Reference> references;
  references.reserve(scene.triangle_count());
  for (u32 i = 0; i < scene.triangle_count(); ++i) {
    if (!is_finite(corners[i])) continue;
    const Box box = raywalk::bounds_of(corners[i]);
    references.push_back({box.lo, i, box.hi, 0});
  }
  return references;
}

/// One of both spans is empty.
void write_triangles(SceneView scene, std::span<const Reference> references, std::span<Corners> corners,
                     std::span<Transform> transforms) {
  tbb::parallel_for(size_t{0}, corners.size(), [&](size_t i) {
    const u32 id = references[i].id;
    const Corners& t = scene.corners()[id];
    corners[i] = {t.a, id, t.b, 0, t.c, 0};
  });
  tbb::parallel_for(size_t{0}, transforms.size(),
                    [&](size_t i) { transforms[i] = transform_of(scene.corners()[references[i].id]); });
}

void check(SceneView scene, const Config& config) {
  if (config.bins < 2 || config.bins > kMaxBins) throw std::invalid_argument("bvh: bins must be 2 to 64");
  if (config.max_leaf < 1 || config.max_leaf > kMaxLeaf) throw std::invalid_argument("bvh: max_leaf must be 1 to 8");
  if (!(config.traversal_cost > 0) || !(config.intersection_cost > 0)) {
    throw std::invalid_argument("bvh: costs must be positive");
  }
  if (scene.header().corners.count > kMaxTriangles) {
    throw std::length_error("bvh: more than 268435456 triangles");
  }
}

}  // namespace

BuiltStructure build(SceneView scene, const Config& config) {
  const auto start = std::chrono::steady_clock::now();
  check(scene, config);
  BuiltStructure built{{}, {}, {config.triangles, static_cast<u32>(config.nodes)}};
  std::vector<Reference> references = finite_references(scene);
  const u32 count = static_cast<u32>(references.size());
  const Box bounds = bounds_of(references);
  Tree tree(references, config);
  Packer packer(references, tree, config, bounds, built.stats);
  Child root = kLeafBit;
  u32 inner_nodes = 0;
  if (count > 0) {
    root = tree.grow(0, count, bounds, 0);
    inner_nodes = packer.count(root, bounds, 0);
  }

  BlobPlan plan(sizeof(Header));
  const auto nodes_of = [&](NodeFormat format) { return config.nodes == format ? inner_nodes : 0; };
  const Slice<Node> nodes = plan.add<Node>(nodes_of(NodeFormat::floats));
  const Slice<HalfNode> halves = plan.add<HalfNode>(nodes_of(NodeFormat::halves));
  const Slice<ByteNode> bytes = plan.add<ByteNode>(nodes_of(NodeFormat::bytes));
  const Slice<Corners> corners = plan.add<Corners>(config.triangles == TriangleRecords::corners ? count : 0);
  const Slice<Transform> transforms = plan.add<Transform>(config.triangles == TriangleRecords::transforms ? count : 0);
  built.blob = plan.allocate();
  const u64 size_bytes = built.blob.size_bytes();
  // Alignment gaps are zero, so that equal structures are equal bytes.
  std::memset(built.blob.data(), 0, sizeof(Header));
  std::memset(built.blob.data() + size_bytes - kBlobAlignment, 0, kBlobAlignment);
  const float half_extent = count > 0 ? half_extent_of(bounds) : 0.0f, unit = unit_of_halves(half_extent);
  if (config.nodes == NodeFormat::floats) {
    root = packer.pack(root, slice_of(built.blob, nodes));
  } else {
    std::vector<Node> precise(inner_nodes);
    root = packer.pack(root, precise);
    compress(precise, unit, slice_of(built.blob, halves));
    compress(precise, slice_of(built.blob, bytes));
  }
  write_triangles(scene, references, slice_of(built.blob, corners), slice_of(built.blob, transforms));
  Header& header = *reinterpret_cast<Header*>(built.blob.data());
  header.nodes_offset = nodes.count > 0 ? nodes.offset : halves.count > 0 ? halves.offset : bytes.offset;
  header.node_count = inner_nodes;
  header.format = built.form.nodes;
  header.unit = unit;
  header.triangles_offset = corners.count > 0 ? corners.offset : transforms.offset;
  header.triangle_count = count;
  header.bounds = bounds;
  header.root = root;
  header.depth = built.stats.max_depth;
  if (count > 0) {
    header.centre = bounds.centre();
    header.half_extent = half_extent;
  }
  built.stats.size_bytes = size_bytes;
  built.stats.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return built;
}

}  // namespace raywalk::bvh
