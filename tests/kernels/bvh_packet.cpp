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

TEST(BvhPacket, OneSumTellsAllVotes) {
  using Eight = Lanes<8>;
  using bvh::packet::Votes;
  // Left first, left alone (first, that is), right first, neither: the last has no say.
  const u32 left_first = Votes::of_lane(true, true, -1), left_alone = Votes::of_lane(true, false, -1);
  const u32 right_first = Votes::of_lane(true, true, 1), neither = Votes::of_lane(false, false, 0);
  const u32 mostly_left[] = {left_first, left_alone, left_alone, right_first, neither, neither, neither, neither};
  const u32 mostly_right[] = {right_first, right_first, left_alone, neither, neither, neither, neither, neither};
  const u32 undecided[] = {right_first, left_first, neither, neither, neither, neither, neither, neither};
  const u32 only_left[] = {left_alone, neither, neither, neither, neither, neither, neither, neither};
  const Votes left{Eight::sum(mostly_left)}, right{Eight::sum(mostly_right)}, even{Eight::sum(undecided)};
  EXPECT_TRUE(left.left() && left.right() && !left.right_first(8));
  EXPECT_TRUE(right.left() && right.right() && right.right_first(8));
  EXPECT_TRUE(!even.right_first(8));
  const Votes alone{Eight::sum(only_left)};
  EXPECT_TRUE(alone.left() && !alone.right());
}

TEST(BvhPacket, VotesOfTheLargestPacketFit) {
  using Most = Lanes<bvh::packet::Votes::kMaxLanes>;
  u32 votes[Most::kCount];
  for (u32& vote : votes) vote = bvh::packet::Votes::of_lane(true, true, 1);
  const bvh::packet::Votes all{Most::sum(votes)};
  EXPECT_TRUE(all.left() && all.right() && all.right_first(Most::kCount));
  for (u32& vote : votes) vote = bvh::packet::Votes::of_lane(false, true, -1);
  const bvh::packet::Votes right{Most::sum(votes)};
  EXPECT_TRUE(!right.left() && right.right() && !right.right_first(Most::kCount));
}

}  // namespace
}  // namespace raywalk::test
