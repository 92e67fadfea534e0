// The BVH as a structure: every finite triangle once, boxes that contain, bounded depth, the same bytes every time.
#include <tbb/global_control.h>

#include <stdexcept>

#include "kernels/accel/bvh/layout.h"
#include "tests/kernels/bvh_check.h"

namespace raywalk::test {
namespace {

/// Walks the tree and checks every box against the triangles below it.
class Inspector {
 public:
  explicit Inspector(const Blob& blob) : blob_(blob), header_(blob.header<bvh::Header>()) {}

  Box walk(bvh::Child child, u32 depth) {
    deepest = std::max(deepest, depth);
    Box box;
    if (bvh::is_leaf(child)) {
      ++leaves;
      for (u32 i = 0; i < bvh::leaf_count(child); ++i) {
        const Corners& t = slice_of(blob_, header_.triangles<Corners>())[bvh::leaf_first(child) + i];
        ids.push_back(t.id);
        box.add(raywalk::bounds_of(t));
      }
      return box;
    }
    ++inner;
    const bvh::Node& node = slice_of(blob_, header_.nodes<bvh::Node>())[child];
    for (u32 side = 0; side < 2; ++side) {
      const Box below = walk(node.child[side], depth + 1);
      for (u32 axis = 0; axis < 3; ++axis) {
        const double centre = header_.centre[axis];
        EXPECT_LE(static_cast<double>(node.planes[axis][side]), below.lo[axis] - centre);
        EXPECT_GE(static_cast<double>(node.planes[axis][side + 2]), below.hi[axis] - centre);
      }
      box.add(below);
    }
    return box;
  }

  u32 leaves = 0, inner = 0, deepest = 0;
  std::vector<u32> ids;

 private:
  const Blob& blob_;
  const bvh::Header& header_;
};

void expect_sound(const Mesh& mesh, const bvh::Config& config = {}) {
  const Blob scene = make_scene(mesh);
  const BuiltStructure built = bvh::build(view_of(scene), config);
  const bvh::Header& header = built.blob.header<bvh::Header>();
  Inspector found(built.blob);
  const Box bounds = found.walk(header.root, 0);
  EXPECT_TRUE(bounds.lo == header.bounds.lo && bounds.hi == header.bounds.hi);
  std::sort(found.ids.begin(), found.ids.end());
  std::vector<u32> expected;
  for (u32 i = 0; i < mesh.size(); ++i) {
    if (is_finite(mesh[i])) expected.push_back(i);
  }
  EXPECT_EQ(found.ids, expected);
  EXPECT_LE(found.deepest, bvh::kMaxDepth);
  EXPECT_EQ(found.deepest, built.stats.max_depth);
  EXPECT_EQ(found.deepest, header.depth);
  EXPECT_EQ(found.leaves, built.stats.leaves);
  EXPECT_EQ(found.leaves + found.inner, built.stats.nodes);
  EXPECT_EQ(found.inner, header.node_count);
  EXPECT_EQ(expected.size(), built.stats.references);
  EXPECT_EQ(built.blob.size_bytes(), built.stats.size_bytes);
  EXPECT_GT(built.stats.build_ms, 0.0);
}

TEST(BvhBuild, EveryTriangleOnceInBoxesThatContainIt) {
  expect_sound(random_soup(1, 5000));
  expect_sound(icosphere(4, 1e-3f, {1e5f, -2e4f, 7}));
  expect_sound(quad_grid(40, 1, 3.0f));
  expect_sound(integer_lattice(2, 2000, 5));
  Mesh mesh = random_soup(3, 1000);
  for (u32 i = 0; i < mesh.size(); i += 7) mesh[i].c.x = std::nanf("");
  expect_sound(mesh);
}

TEST(BvhBuild, DepthIsBounded) {
  // Each triangle is half as large and half as far as the one before: every useful plane takes off few of them.
  Mesh nested;
  for (u32 copy = 0; copy < 40; ++copy) {
    float size = 1.0f;
    for (u32 k = 0; k < 120; ++k, size *= 0.5f) {
      nested.push_back(triangle({size, 0, 0}, {size * 1.25f, size * 0.1f, 0}, {size, 0, size * 0.1f}));
    }
  }
  for (const u32 max_leaf : {1u, 4u}) {
    bvh::Config config;
    config.max_leaf = max_leaf;
    config.bins = 4;
    expect_sound(nested, config);
    expect_like_brute(nested, all_rays(nested, 50), config);
  }
}

TEST(BvhBuild, ExtremeExtentsTerminate) {
  Mesh mesh = random_soup(4, 500);
  append(mesh, transformed(random_soup(5, 500), 3e38f / 2, {0, 0, 0}));
  append(mesh, transformed(random_soup(6, 500), 1e-38f, {0, 0, 0}));
  expect_sound(mesh);
}

TEST(BvhBuild, SameBytesWhateverTheThreads) {
  const Blob scene = make_scene(random_soup(9, 150000, 0.05f));
  const BuiltStructure many = bvh::build(view_of(scene), {});
  tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const BuiltStructure one = bvh::build(view_of(scene), {});
  ASSERT_EQ(one.blob.size_bytes(), many.blob.size_bytes());
  EXPECT_EQ(std::memcmp(one.blob.data(), many.blob.data(), one.blob.size_bytes()), 0);
  EXPECT_EQ(one.stats.sah_cost, many.stats.sah_cost);
}

TEST(BvhBuild, RelocatedBlobGivesTheSameHits) {
  const Mesh mesh = random_soup(10, 2000);
  const Blob scene = make_scene(mesh);
  BuiltStructure built = bvh::build(view_of(scene), {});
  Blob copy(built.blob.size_bytes());
  std::memcpy(copy.data(), built.blob.data(), copy.size_bytes());
  const auto rays = random_rays(2, 500, bounds_of(mesh));
  std::vector<Hit> before;
  for (const Ray& ray : rays) before.push_back(bvh_closest(built.blob.data(), view_of(scene), ray));
  std::memset(built.blob.data(), 0xff, built.blob.size_bytes());
  for (u32 i = 0; i < rays.size(); ++i) {
    EXPECT_TRUE(same(bvh_closest(copy.data(), view_of(scene), rays[i]), before[i]));
  }
}

TEST(BvhBuild, RefusesAConfigurationOutOfRange) {
  const Blob scene = make_scene({});
  bvh::Config config;
  config.max_leaf = 9;
  EXPECT_THROW(bvh::build(view_of(scene), config), std::invalid_argument);
  config = {};
  config.bins = 1;
  EXPECT_THROW(bvh::build(view_of(scene), config), std::invalid_argument);
  config = {};
  config.traversal_cost = 0;
  EXPECT_THROW(bvh::build(view_of(scene), config), std::invalid_argument);
}

TEST(BvhBuild, KindBuildsWithItsDefaults) {
  const Kind& kind = bvh::kind();
  EXPECT_EQ(kind.name, "bvh");
  OptionValues options;
  for (const Option& option : kind.options) {
    EXPECT_LE(option.min, option.default_value);
    EXPECT_LE(option.default_value, option.max);
    EXPECT_FALSE(option.help.empty());
    options.emplace(option.name, option.default_value);
  }
  const Blob scene = make_scene(random_soup(1, 300));
  const BuiltStructure by_kind = kind.build(view_of(scene), options), directly = bvh::build(view_of(scene), {});
  ASSERT_EQ(by_kind.blob.size_bytes(), directly.blob.size_bytes());
  EXPECT_EQ(std::memcmp(by_kind.blob.data(), directly.blob.data(), directly.blob.size_bytes()), 0);
}

}  // namespace
}  // namespace raywalk::test
