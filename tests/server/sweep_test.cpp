// The rays of a sweep and its choices of knobs: the same each time, and what their names say.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "server/accuracy/sweep/combinations.h"
#include "server/accuracy/sweep/errors.h"
#include "server/accuracy/sweep/ray_lists.h"
#include "server/scene/scene.h"

namespace raywalk::accuracy {
namespace {

/// A unit tetrahedron and a triangle that is a point, with one lamp.
LoadedScene tetrahedron() {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.triangles = {{0, 2, 1, 0}, {0, 1, 3, 0}, {0, 3, 2, 0}, {1, 2, 3, 0}, {1, 1, 1, 0}};
  scene.materials = {default_material()};
  scene.lights = {{{3, 3, 3}, {1, 1, 1}}};
  LoadedScene loaded;
  loaded.blob = std::make_shared<const Blob>(pack(scene));
  loaded.bounds = bounds_of(scene);
  loaded.camera_path = orbit_around(loaded.bounds);
  loaded.info.triangles = scene.triangles.size();
  return loaded;
}

class SweepRays : public testing::Test {
 protected:
  SceneView view() const { return {loaded_.blob->data()}; }
  /// By the oracle, with barycentrics of a point somewhere inside.
  RayMaker maker(u64 rays, u64 seed = 1) {
    return {loaded_, rays, seed, [this](const std::vector<Ray>& asked) {
              std::vector<Hit> hits;
              for (const Ray& ray : asked) {
                hits.push_back(oracle_.closest(ray).hit);
                hits.back().u = hits.back().v = 0.25f;
              }
              return hits;
            }};
  }
  RayList make(RayKind kind, u64 rays = 256, u64 seed = 1, const std::string& spawn = "error-bound") {
    return maker(rays, seed).make(kind, spawn);
  }

  LoadedScene loaded_ = tetrahedron();
  oracle::SceneOracle oracle_{view()};
};

bool same(const std::vector<Ray>& a, const std::vector<Ray>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Ray)) == 0;
}

TEST_F(SweepRays, FollowFromTheSeed) {
  for (const RayKind kind : kAllRayKinds) {
    const RayList list = make(kind);
    ASSERT_GT(list.rays.size(), 16u) << name_of(kind);
    EXPECT_TRUE(same(list.rays, make(kind).rays)) << name_of(kind);
    const bool seeded = kind != RayKind::primary && kind != RayKind::shadow;
    EXPECT_EQ(same(list.rays, make(kind, 256, 2).rays), !seeded) << name_of(kind);
    for (const Ray& ray : list.rays) EXPECT_TRUE(is_valid(ray));
  }
}

TEST_F(SweepRays, AreNearTheNumberAskedFor) {
  EXPECT_EQ(make(RayKind::random, 1000).rays.size(), 1000u);
  EXPECT_EQ(make(RayKind::edge, 1000).rays.size(), 1000u);
  EXPECT_EQ(primary_side(100'000), 160u);
  EXPECT_EQ(primary_side(1), 8u);
  EXPECT_EQ(make(RayKind::primary, 1024).rays.size(), 1024u);
}

TEST_F(SweepRays, GoThroughEdgesAndVertices) {
  for (const RayKind kind : {RayKind::edge, RayKind::vertex}) {
    const RayList list = make(kind, 500);
    ASSERT_EQ(list.own.size(), list.rays.size());
    for (std::size_t i = 0; i < list.rays.size(); ++i) {
      ASSERT_LT(list.own[i], 4u) << "a point has no edges";
      const oracle::Crossing crossing = oracle::classify(list.rays[i], view().corners()[list.own[i]]);
      EXPECT_TRUE(crossing.near || crossing.position == oracle::Position::edge ||
                  crossing.position == oracle::Position::vertex || crossing.position == oracle::Position::coplanar)
          << name_of(kind) << " ray " << i;
    }
  }
}

TEST_F(SweepRays, LeaveTheSurfaceByTheirOffset) {
  const RayList none = make(RayKind::shadow, 256, 1, "none"), bound = make(RayKind::shadow);
  ASSERT_EQ(none.rays.size(), bound.rays.size());
  EXPECT_EQ(none.own, bound.own);
  EXPECT_FALSE(same(none.rays, bound.rays));
  for (const Ray& ray : bound.rays) EXPECT_EQ(ray.tmax, 1.0f);
  for (std::size_t i = 0; i < bound.rays.size(); ++i) {
    EXPECT_NE(oracle_.closest(bound.rays[i]).hit.id, bound.own[i]) << "met the surface that it leaves";
  }
  EXPECT_THROW(make(RayKind::shadow, 256, 1, "far"), std::invalid_argument);
}

TEST_F(SweepRays, MissOrAreInvalid) {
  const std::vector<Ray> misses = maker(100).misses();
  ASSERT_EQ(misses.size(), 100u);
  for (const Ray& ray : misses) {
    EXPECT_TRUE(is_valid(ray));
    EXPECT_FALSE(oracle_.closest(ray).is_hit());
  }
  for (const Ray& ray : made_invalid(misses)) EXPECT_FALSE(is_valid(ray));
}

TEST_F(SweepRays, AreJudged) {
  const VertexFans fans(view());
  const auto ignore = [](double) {};
  for (const RayKind kind : {RayKind::edge, RayKind::random}) {
    const RayList list = make(kind, 300);
    Answers answers;
    u64 hits = 0;
    for (const Ray& ray : list.rays) {
      answers.hits.push_back(oracle_.closest(ray).hit);
      hits += answers.hits.back().id != kMiss;
    }
    if (kind == RayKind::edge) answers.beyond.assign(list.rays.size(), miss_of(list.rays[0]));
    Judge judge(oracle_, view(), fans, list);
    const SweepErrors right = judge.errors_of(answers, ignore);
    EXPECT_EQ(right.figures.rays(), 300u);
    EXPECT_EQ(right.wrong, 0u);
    EXPECT_EQ(right.double_hits.has_value(), kind == RayKind::edge);
    EXPECT_FALSE(right.self_hits);
    for (std::size_t i = 0; i < list.rays.size(); ++i) answers.hits[i] = miss_of(list.rays[i]);
    const SweepErrors blind = judge.errors_of(answers, ignore);
    EXPECT_GT(blind.wrong, 0u);
    if (kind == RayKind::random) {  // away from edges every missing hit is wrong
      EXPECT_EQ(blind.figures.count(oracle::Verdict::false_miss), hits);
    }
    EXPECT_THROW(judge.errors_of(answers, [](double) { throw std::runtime_error("stop"); }), std::runtime_error);
  }
}

class DoubleHits : public testing::Test {
 protected:
  /// Of triangles, three points each.
  void make(const std::vector<Vec3>& points) {
    Scene scene;
    scene.positions = points;
    for (u32 i = 0; i < points.size(); i += 3) scene.triangles.push_back({i, i + 1, i + 2, 0});
    scene.materials = {default_material()};
    blob_ = pack(scene);
  }
  bool twice(const Ray& ray, u32 first, u32 second) const {
    const SceneView view{blob_.data()};
    return is_double_hit(ray, view, first, second, VertexFans(view));
  }
  Blob blob_;
};

TEST_F(DoubleHits, AreOfNeighboursThatThePlaneOfTheirEdgeParts) {
  make({{0, -1, 0},
        {0, 1, 0},
        {-1, 0, 0},  // left of an edge
        {0, -1, 0},
        {1, 0, 0},
        {0, 1, 0},  // right of it
        {0, -1, 0},
        {1, 0, -0.5f},
        {0, 1, 0},  // right too: folded back
        {5, 5, 0},
        {6, 5, 0},
        {5, 6, 0}});
  const Ray right{{0.001f, 0, 1}, 0, {0, 0, -1}, 10}, left{{-0.001f, 0, 1}, 0, {0, 0, -1}, 10};
  EXPECT_TRUE(twice(right, 1, 0)) << "a flat sheet is passed once";
  EXPECT_FALSE(twice(right, 1, 2)) << "both are really met";
  EXPECT_FALSE(twice(left, 1, 2)) << "a silhouette";
  EXPECT_FALSE(twice(right, 1, 3)) << "no neighbours";
  EXPECT_FALSE(twice(right, 1, 1));
}

TEST_F(DoubleHits, AtAVertexAreOfSurfacesThatDoNotTurnBack) {
  const Vec3 hub{0, 0, 0}, a{1, 0, 0}, b{0, 1, 0}, c{-1, -1, 0}, behind{1, 1, -1};
  const Ray ray{{-1e-7f, 1e-8f, 1}, 0, {0, 0, -1}, 10};
  make({hub, a, b, hub, b, c, hub, c, a});
  EXPECT_TRUE(twice(ray, 0, 1));
  EXPECT_TRUE(twice(ray, 0, 2));
  make({hub, a, b, hub, b, c, hub, c, behind, hub, behind, a});  // the last one shows its back
  EXPECT_FALSE(twice(ray, 0, 1));
  make({hub, a, b, hub, b, c, hub, c, {0, 0, -1}});  // one is seen edge-on
  EXPECT_FALSE(twice(ray, 0, 1));
}

TEST_F(DoubleHits, AtAVertexAreNotOfMeshesThatTouchThere) {
  const Vec3 hub{0, 0, 0}, a{1, 0, 0}, b{0, 1, 0}, c{-1, -1, 0}, p{1, 1, 0}, q{-1, 1, 0}, r{0, -1, 0};
  const Ray ray{{-1e-7f, 1e-8f, 1}, 0, {0, 0, -1}, 10};
  make({hub, a, b, hub, b, c, hub, c, a, hub, p, q, hub, q, r, hub, r, p});  // two fans in one plane
  EXPECT_TRUE(twice(ray, 0, 2));
  EXPECT_TRUE(twice(ray, 3, 5));
  EXPECT_FALSE(twice(ray, 0, 3)) << "each is met once";
  EXPECT_FALSE(twice(ray, 2, 4));
  make({hub, a, b, hub, b, c, hub, c, a, hub, b, p});  // three triangles share an edge
  EXPECT_TRUE(twice(ray, 0, 2));
  EXPECT_TRUE(twice(ray, 0, 1)) << "joined by the other way round";
  EXPECT_FALSE(twice(ray, 0, 3));
  const Vec3 over_a{1, 0.5f, 0.1f};
  make({hub, a, b, hub, b, c, hub, c, r, hub, r, over_a});  // an open fan whose ends overlap
  EXPECT_FALSE(twice(ray, 0, 3));
}

TEST(Continued, RaysBeginBehindTheirHit) {
  const std::vector<Ray> rays = {{{0, 0, 0}, 0, {0, 0, 1}, 10}, {{0, 0, 0}, 0, {0, 0, 1}, 10}};
  const std::vector<Ray> out = continued_rays(rays, {{1.0f, 3, 0, 0}, miss_of(rays[1])});
  EXPECT_EQ(out[0].tmin, std::nextafter(1.0f, 2.0f));
  EXPECT_GT(out[0].tmax, out[0].tmin);
  EXPECT_LT(out[0].tmax, 1.00001f);
  EXPECT_FALSE(is_valid(out[1]));
}

class KnobSets : public testing::Test {
 protected:
  KnobSets() {
    traversal_.options = {{.name = "registers", .help = "", .max = 255},
                          {.name = "intersector", .help = "", .choices = {"watertight", "fast"}},
                          {.name = "slab", .help = "", .choices = {"padded", "ize", "plain"}},
                          {.name = "spawn", .help = "", .choices = {"error-bound", "none"}}};
  }
  TraversalInfo traversal_{"t", "", false, {}};
  AccuracySpec spec_;
};

TEST_F(KnobSets, AreAllTestsWithAllBoxesAndEachOffset) {
  const std::vector<GivenOptions> sets = knob_sets_of(spec_, traversal_);
  ASSERT_EQ(sets.size(), 2u * 3u + 1u);
  EXPECT_TRUE(sets.front().empty()) << "the strict one is the first";
  EXPECT_EQ(sets.back(), (GivenOptions{{"spawn", "none"}}));
}

TEST_F(KnobSets, ChangeOneAtATimeInAQuickSweep) {
  spec_.quick = true;
  EXPECT_EQ(knob_sets_of(spec_, traversal_).size(), 1u + 1u + 2u + 1u);
}

TEST_F(KnobSets, OfTheSpecAreThoseThatTheTraversalHas) {
  spec_.knob_sets = {{{"slab", "ize"}}, {{"stack_entries", 2.0}}};
  EXPECT_EQ(knob_sets_of(spec_, traversal_), (std::vector<GivenOptions>{{{"slab", "ize"}}}));
}

TEST(Combinations, DifferInTheSpawnOffsetForSpawnedRaysAlone) {
  Combination strict, other;
  strict.kernel = {{"intersector", 0}, {"spawn", 0}};
  other.kernel = {{"intersector", 0}, {"spawn", 2}};
  const std::vector<Combination> all = {strict, other};
  EXPECT_EQ(combinations_for(RayKind::shadow, all).size(), 2u);
  EXPECT_EQ(combinations_for(RayKind::edge, all), (std::vector<std::size_t>{0}));
}

TEST(Combinations, TellKnobsFromOptionsOfTheCompiler) {
  for (const char* name : {"intersector", "slab", "spawn", "stack_entries"}) EXPECT_TRUE(is_knob(name)) << name;
  for (const char* name : {"registers", "block", ""}) EXPECT_FALSE(is_knob(name)) << name;
}

}  // namespace
}  // namespace raywalk::accuracy
