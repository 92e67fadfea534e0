// The kd-tree and its two short-stack traversals: hits as brute force, sound nodes, same bytes always.
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "kernels/accel/kdtree/kind.h"
#include "kernels/accel/kdtree/short_stack_2.h"
#include "kernels/accel/kdtree/short_stack_3.h"
#include "tests/support/spatial_cases.h"

namespace raywalk::test {
namespace {

const auto kTrace3 = [](auto&&... arguments) { kdtree::short_stack_3::traverse(arguments...); };
const auto kTrace2 = [](auto&&... arguments) { kdtree::short_stack_2::traverse(arguments...); };

BuiltStructure build_tree(const Blob& scene, const OptionValues& options = {}) {
  return kdtree::kind().build(view_of(scene), options_of(kdtree::kind(), options));
}

void expect_same(const Blob& scene, const Blob& tree, const std::vector<Ray>& rays, const std::vector<Answer>& answers,
                 const std::string& what) {
  expect_answers(answers, view_of(scene), tree.data(), rays, kTrace3, what + ", kdt-3");
  expect_answers(answers, view_of(scene), tree.data(), rays, kTrace2, what + ", kdt-2");
}

/// Splits as long as the depth allows: deep trees, many restarts.
const OptionValues kEager{{"traversal_cost", 0.01}, {"intersection_cost", 100}, {"empty_bonus", 0.9}};

TEST(KdTree, HitsAsBruteForce) {
  const OptionValues variants[] = {{}, {{"sah", 1}}, kEager, {{"empty_bonus", 0}, {"traversal_cost", 0.2}}};
  for (const SpatialCase& c : spatial_cases()) {
    const Blob scene = make_scene(c.mesh);
    const std::vector<Answer> answers = brute_force(view_of(scene), c.rays);
    for (size_t i = 0; i < std::size(variants); ++i) {
      expect_same(scene, build_tree(scene, variants[i]).blob, c.rays, answers,
                  c.name + ", variant " + std::to_string(i));
    }
  }
}

TEST(KdTree, ManyIdenticalTrianglesTerminate) {
  const Mesh mesh = repeated({triangle({0, 0, 0}, {1, 0, 0.5f}, {0, 1, 0.25f})}, 100000);
  const Blob scene = make_scene(mesh);
  const std::vector<Ray> rays = mixed_rays(51, 10, mesh);
  const std::vector<Answer> answers = brute_force(view_of(scene), rays);
  for (const double sah : {0.0, 1.0}) {
    const BuiltStructure tree = build_tree(scene, {{"sah", sah}});
    EXPECT_LT(tree.stats.references, 1000000u);
    expect_same(scene, tree.blob, rays, answers, "identical");
  }
}

/// Walks the tree: indices in range, each node reached once, leaves' references ascending.
void check_nodes(const Blob& blob, SceneView scene, const BuildStats& stats) {
  const auto& header = blob.header<kdtree::Header>();
  const auto nodes = slice_of(blob, header.nodes);
  const auto references = slice_of(blob, header.references);
  std::vector<u32> reached(nodes.size());
  u64 leaves = 0, counted = 0;
  u32 deepest = 0;
  const std::function<void(u32, u32)> visit = [&](u32 index, u32 depth) {
    ASSERT_LT(index, nodes.size());
    ++reached[index];
    const kdtree::Node node = nodes[index];
    if (!node.leaf()) {
      EXPECT_TRUE(is_finite(node.split()));
      visit(node.index(), depth + 1);
      visit(node.index() + 1, depth + 1);
      return;
    }
    deepest = std::max(deepest, depth);
    ++leaves;
    counted += node.count();
    ASSERT_LE(node.index() + u64{node.count()}, references.size());
    for (u32 i = 0; i < node.count(); ++i) {
      EXPECT_LT(references[node.index() + i], scene.triangle_count());
      if (i > 0) {
        EXPECT_LT(references[node.index() + i - 1], references[node.index() + i]);
      }
    }
  };
  visit(0, 0);
  for (const u32 times : reached) EXPECT_EQ(times, 1u);
  EXPECT_EQ(stats.nodes, nodes.size());
  EXPECT_EQ(stats.leaves, leaves);
  EXPECT_EQ(stats.references, counted);
  EXPECT_EQ(stats.references, references.size());
  EXPECT_EQ(stats.max_depth, deepest);
  EXPECT_EQ(stats.size_bytes, blob.size_bytes());
}

TEST(KdTree, NodesAreSound) {
  const Blob scene = make_scene(random_soup(52, 30000, 0.05f));
  for (const double sah : {0.0, 1.0}) {
    const BuiltStructure tree = build_tree(scene, {{"sah", sah}});
    check_nodes(tree.blob, view_of(scene), tree.stats);
    EXPECT_LE(tree.stats.max_depth, 8 + 1.3 * std::log2(30000.0));
    EXPECT_GT(tree.stats.sah_cost, 0);
  }
  const Blob empty = make_scene({});
  const BuiltStructure none = build_tree(empty);
  check_nodes(none.blob, view_of(empty), none.stats);
  EXPECT_EQ(none.stats.nodes, 1u);
}

TEST(KdTree, ExactSahCostsNoMoreThanSampled) {
  const Blob scene = make_scene(icosphere(5));
  const double exact = build_tree(scene).stats.sah_cost, sampled = build_tree(scene, {{"sah", 1}}).stats.sah_cost;
  EXPECT_LT(exact, sampled * 1.01);
  EXPECT_LT(sampled, exact * 1.25);
}

TEST(KdTree, VisitsFewNodes) {
  const Mesh mesh = icosphere(5);
  const Blob scene = make_scene(mesh);
  const BuiltStructure tree = build_tree(scene);
  Counter three, two;
  const std::vector<Ray> rays = vertex_rays(53, 2000, mesh);
  for (const Ray& ray : rays) {
    ClosestHit a(ray), b(ray);
    kTrace3(tree.blob.data(), view_of(scene), ray, a, three);
    kTrace2(tree.blob.data(), view_of(scene), ray, b, two);
    EXPECT_EQ(a.best.id, b.best.id);
  }
  EXPECT_EQ(three.counts.steps, two.counts.steps);
  EXPECT_LT(three.counts.steps, 100 * rays.size());
  EXPECT_LT(three.counts.tests, 30 * rays.size());
}

TEST(KdTree, SameBytesWithAnyNumberOfThreads) {
  const Blob scene = make_scene(random_soup(54, 40000, 0.05f));
  for (const double sah : {0.0, 1.0}) {
    const BuiltStructure many = build_tree(scene, {{"sah", sah}});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const BuiltStructure single = build_tree(scene, {{"sah", sah}});
    ASSERT_EQ(many.stats.nodes, single.stats.nodes);
    ASSERT_EQ(many.stats.references, single.stats.references);
    EXPECT_EQ(many.stats.sah_cost, single.stats.sah_cost);
    const auto& header = many.blob.header<kdtree::Header>();
    const auto bytes = [&](const Blob& blob, auto slice) { return std::as_bytes(slice_of(blob, slice)); };
    EXPECT_TRUE(std::ranges::equal(bytes(many.blob, header.nodes), bytes(single.blob, header.nodes)));
    EXPECT_TRUE(std::ranges::equal(bytes(many.blob, header.references), bytes(single.blob, header.references)));
  }
}

TEST(KdTree, BlobMayMove) {
  const Mesh mesh = random_soup(55, 500);
  const Blob scene = make_scene(mesh);
  Blob copy;
  {
    const BuiltStructure tree = build_tree(scene);
    copy = Blob(tree.blob.size_bytes());
    std::memcpy(copy.data(), tree.blob.data(), copy.size_bytes());
  }
  const std::vector<Ray> rays = mixed_rays(56, 200, mesh);
  expect_same(scene, copy, rays, brute_force(view_of(scene), rays), "moved");
}

TEST(KdTree, ShortStackForgetsItsOldestEntry) {
  kdtree::short_stack_3::Stack stack(kStackEntries);
  for (u32 i = 0; i < 6; ++i) stack.push(static_cast<float>(i), 10.0f, i);
  float enter = 0, exit = 0;
  u32 node = 0;
  for (u32 i = 5; i >= 2; --i) {
    ASSERT_TRUE(stack.pop(enter, exit, node));
    EXPECT_EQ(node, i);
    EXPECT_EQ(enter, static_cast<float>(i));
  }
  EXPECT_FALSE(stack.pop(enter, exit, node));
}

}  // namespace
}  // namespace raywalk::test
