// The packet traversal's own promises: inactive lanes are left alone, work is counted per active lane.
#include "tests/kernels/bvh_check.h"

namespace raywalk::test {
namespace {

/// 8 x 8 rays from one eye towards the origin.
std::vector<Ray> tile(float spread) {
  std::vector<Ray> rays;
  for (u32 i = 0; i < kPacket; ++i) {
    const float x = static_cast<float>(i % 8) - 3.5f, y = static_cast<float>(i / 8) - 3.5f;
    rays.push_back({{0, 0, 4}, 0.0f, {x * spread, y * spread, -1}, kFarAway});
  }
  return rays;
}

TEST(BvhPacket, InactiveLanesAreNotTouched) {
  const Blob scene = make_scene(icosphere(3));
  const BuiltStructure built = bvh::build(view_of(scene), {});
  const std::vector<Ray> rays = tile(0.02f);
  bool active[kPacket];
  ClosestHit queries[kPacket];
  Counter counters[kPacket];
  for (u32 i = 0; i < kPacket; ++i) {
    active[i] = i % 3 == 0;
    queries[i] = ClosestHit(rays[i]);
    if (!active[i]) queries[i].best.t = std::nanf("");
  }
  bvh::packet::traverse<Lanes<kPacket>>(built.blob.data(), view_of(scene), rays.data(), active, queries, counters);
  for (u32 i = 0; i < kPacket; ++i) {
    if (active[i]) {
      EXPECT_TRUE(same(queries[i].best, brute_closest(view_of(scene), rays[i])));
      EXPECT_GT(counters[i].counts.steps, 0u);
      EXPECT_EQ(counters[i].counts.steps, counters[0].counts.steps);
    } else {
      EXPECT_EQ(queries[i].best.id, kMiss);
      EXPECT_TRUE(queries[i].best.t != queries[i].best.t);
      EXPECT_EQ(counters[i].counts.steps + counters[i].counts.tests, 0u);
    }
  }
}

TEST(BvhPacket, NoActiveLaneMeansNoWork) {
  const Blob scene = make_scene(icosphere(2));
  const BuiltStructure built = bvh::build(view_of(scene), {});
  const PacketRun<AnyHit> run(built.blob.data(), view_of(scene), nullptr, 0);
  for (const Counter& c : run.counters) EXPECT_EQ(c.counts.steps + c.counts.tests, 0u);
}

TEST(BvhPacket, AloneARayWorksAsMuchAsItsOwnTraversal) {
  const Blob scene = make_scene(icosphere(4));
  const BuiltStructure built = bvh::build(view_of(scene), {});
  for (const Ray& ray : tile(0.1f)) {
    const PacketRun<ClosestHit> run(built.blob.data(), view_of(scene), &ray, 1);
    ClosestHit query(ray);
    Counter alone;
    bvh::while_while::traverse(built.blob.data(), view_of(scene), ray, query, alone);
    // The packet's stack has no distances, so it may visit what the single ray drops, never less.
    EXPECT_GE(run.counters[0].counts.steps, alone.counts.steps);
    EXPECT_GE(run.counters[0].counts.tests, alone.counts.tests);
    EXPECT_LE(run.counters[0].counts.steps, 2 * alone.counts.steps + 4);
  }
}

TEST(BvhPacket, AnyHitStopsWhenAllLanesAreOccluded) {
  Mesh mesh = icosphere(4, 0.5f);
  append(mesh, quad_grid(1, 2, 2.0f, -10.0f, 10.0f));  // a wall in front of the sphere
  const Blob scene = make_scene(mesh);
  const BuiltStructure built = bvh::build(view_of(scene), {});
  const std::vector<Ray> rays = tile(0.02f);
  const auto any = std::make_unique<PacketRun<AnyHit>>(built.blob.data(), view_of(scene), rays.data(), kPacket);
  for (u32 i = 0; i < kPacket; ++i) {
    EXPECT_TRUE(any->queries[i].occluded);
    EXPECT_LE(any->counters[i].counts.tests, 2 * bvh::kMaxLeaf);
  }
}

TEST(Lanes, Collectives) {
  using Eight = Lanes<8>;
  bool flags[8] = {};
  EXPECT_FALSE(Eight::any(flags));
  flags[5] = true;
  EXPECT_TRUE(Eight::any(flags));
  const u32 votes[8] = {0, 0, 3, 0, 1, 1, 1, 0};
  EXPECT_EQ(Eight::vote(votes), 1u << 0 | 1u << 1 | 1u << 3);
  const i32 values[8] = {-1, -1, 0, 1, -1, 0, 0, 0};
  EXPECT_EQ(Eight::sum(values), -2);
}

}  // namespace
}  // namespace raywalk::test
