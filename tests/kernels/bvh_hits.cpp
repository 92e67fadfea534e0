// The BVH finds what the linear loop finds: the same t, id, u and v, and the same occlusion.
#include <limits>

#include "tests/kernels/bvh_check.h"

namespace raywalk::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(BvhHits, RandomSoups) {
  for (u32 seed = 1; seed <= 4; ++seed) {
    const Mesh mesh = random_soup(seed, 1500, seed % 2 ? 0.1f : 1.0f);
    // Of rays at the free edges and corners of single triangles, the test gives some to nobody.
    EXPECT_GT(expect_like_brute(mesh, all_rays(mesh, 150, seed)), 250u);
  }
}

TEST(BvhHits, EveryLeafSizeAndBinCount) {
  const Mesh mesh = random_soup(7, 600, 0.3f);
  for (const u32 max_leaf : {1u, 2u, 8u}) {
    for (const u32 bins : {2u, 16u, 64u}) {
      bvh::Config config;
      config.max_leaf = max_leaf;
      config.bins = bins;
      EXPECT_GT(expect_like_brute(mesh, all_rays(mesh, 50), config), 100u);
    }
  }
}

TEST(BvhHits, SphereEdgesAndVerticesLeakNowhere) {
  const Vec3 centre{0.3f, -0.7f, 5.0f};
  const Mesh mesh = icosphere(3, 2.0f, centre);
  std::vector<Ray> rays = edge_rays(11, 1500, mesh);
  const auto more = vertex_rays(12, 1500, mesh);
  rays.insert(rays.end(), more.begin(), more.end());
  EXPECT_GT(expect_like_brute(mesh, rays), 2800u);  // from outside, some pass the silhouette
  Random random(13);
  for (Ray& ray : rays) {
    const Vec3 target = ray.o + ray.d;
    ray = ray_towards(fma(0.5f, random.direction(), centre), target);
  }
  EXPECT_EQ(expect_like_brute(mesh, rays), rays.size());
}

TEST(BvhHits, RaysInFacePlanesAndAlongEdgesOfBoxes) {
  const Mesh mesh = subdivided_box(6);
  std::vector<Ray> rays = all_rays(mesh, 300, 5);
  for (const float zero : {0.0f, -0.0f}) {
    for (const float along : {1.0f, -1.0f}) {
      for (const float p : {-1.0f, -1.0f / 3.0f, 0.0f, 1.0f}) {
        rays.push_back({{p, 1.0f, -3.0f * along}, 0.0f, {zero, zero, along}, kFarAway});
        rays.push_back({{-3.0f * along, p, -1.0f}, 0.0f, {along, zero, -zero}, kFarAway});
        rays.push_back({{1.0f, -3.0f * along, p}, 0.0f, {zero, along, zero}, kFarAway});
        rays.push_back({{1.0f, 1.0f, p}, 0.0f, {-zero, along, zero}, kFarAway});
      }
    }
  }
  EXPECT_GT(expect_like_brute(mesh, rays), 600u);
}

TEST(BvhHits, FlatGridOnEachAxis) {
  for (u32 axis = 0; axis < 3; ++axis) {
    const Mesh mesh = quad_grid(16, axis, 0.0f);
    EXPECT_GT(expect_like_brute(mesh, all_rays(mesh, 200)), 300u);
  }
}

TEST(BvhHits, IntegerLattice) {
  const Mesh mesh = integer_lattice(3, 400, 4);
  std::vector<Ray> rays = all_rays(mesh, 150);
  Random random(9);
  const auto whole = [&](u32 n) { return static_cast<float>(random.below(n)); };
  while (rays.size() < 1500) {
    const Vec3 d{whole(7) - 3, whole(7) - 3, whole(7) - 3};
    if (largest(magnitude(d)) > 0) rays.push_back({{whole(5), whole(5), whole(5)}, 0.0f, d, kFarAway});
  }
  EXPECT_GT(expect_like_brute(mesh, rays), 700u);
}

TEST(BvhHits, DuplicatesGoToTheLowestId) {
  Mesh mesh = random_soup(21, 200, 0.8f);
  for (u32 copy = 0; copy < 4; ++copy) append(mesh, random_soup(21, 200, 0.8f));
  const std::vector<Ray> rays = random_rays(4, 600, bounds_of(mesh), 1.0f);
  EXPECT_GT(expect_like_brute(mesh, rays), 100u);
  const Blob scene = make_scene(mesh);
  const BuiltStructure built = bvh::build(view_of(scene), {});
  for (const Ray& ray : rays) {
    const Hit hit = bvh_closest(built.blob.data(), view_of(scene), ray);
    EXPECT_TRUE(hit.id == kMiss || hit.id < 200u);
  }
}

TEST(BvhHits, Slivers) {
  const Mesh mesh = slivers(2, 800);
  EXPECT_GT(expect_like_brute(mesh, all_rays(mesh, 200)), 10u);
}

TEST(BvhHits, OffsetsAndScales) {
  for (const float offset : {0.0f, 1e3f, 1e4f, 1e5f, 1e6f}) {
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
      for (const Mesh& shape : {icosphere(2), random_soup(5, 150, 0.4f)}) {
        const Mesh mesh = transformed(shape, scale, {offset, -offset, 0.5f * offset});
        SCOPED_TRACE(testing::Message() << "offset " << offset << " scale " << scale);
        expect_like_brute(mesh, all_rays(mesh, 60));
      }
    }
  }
}

TEST(BvhHits, VeryLargeAndVerySmallScenes) {
  for (const float scale : {1e-12f, 1e-9f, 1e9f, 1e12f}) {
    const Mesh mesh = transformed(icosphere(2), scale, {0, 0, 0});
    SCOPED_TRACE(scale);
    EXPECT_GT(expect_like_brute(mesh, random_rays(6, 200, bounds_of(mesh))), 30u);
  }
}

TEST(BvhHits, DirectionsOfAnyLength) {
  const Mesh mesh = icosphere(2);
  for (const float scale : {1e-38f, 1e-30f, 1e-10f, 1e10f, 1e30f, 1e38f}) {
    std::vector<Ray> rays = random_rays(8, 200, bounds_of(mesh), 1.0f);
    for (Ray& ray : rays) {
      ray.d = normalized(ray.d) * scale;
      ray.tmax = kMaxFloat;
    }
    SCOPED_TRACE(scale);
    expect_like_brute(mesh, rays);
  }
}

TEST(BvhHits, FarOrigins) {
  const Mesh mesh = icosphere(3);
  for (const float reach : {1e3f, 1e5f, 1e7f}) {
    SCOPED_TRACE(reach);
    expect_like_brute(mesh, edge_rays(3, 300, mesh, reach));
    expect_like_brute(mesh, vertex_rays(3, 300, mesh, reach));
  }
}

TEST(BvhHits, SmallScenes) {
  const std::vector<Ray> rays = random_rays(1, 200, Box{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_EQ(expect_like_brute({}, rays), 0u);
  for (u32 count = 1; count <= 9; ++count) expect_like_brute(random_soup(count, count, 1.5f), rays);
  EXPECT_GT(expect_like_brute(random_soup(1, 1, 1.5f), vertex_rays(1, 100, random_soup(1, 1, 1.5f))), 0u);
}

TEST(BvhHits, DegenerateTrianglesAreNeverHit) {
  Mesh mesh;
  Random random(5);
  for (u32 i = 0; i < 300; ++i) {
    const Vec3 p = random.in_box({-1, -1, -1}, {1, 1, 1});
    mesh.push_back(i % 2 ? triangle(p, p, p) : triangle(p, p, {0, 0, 0}));
  }
  EXPECT_EQ(expect_like_brute(mesh, all_rays(mesh, 100)), 0u);
}

TEST(BvhHits, NonFiniteTrianglesDoNotShiftIds) {
  Mesh mesh = random_soup(31, 400, 0.4f);
  const std::vector<Ray> rays = all_rays(mesh, 100);
  for (u32 i = 0; i < mesh.size(); i += 3) mesh[i].b.y = i % 2 ? kNan : kInfinity;
  mesh[0].a.x = -kInfinity;
  EXPECT_GT(expect_like_brute(mesh, rays), 100u);
  for (Corners& t : mesh) t.c.z = kNan;
  EXPECT_EQ(expect_like_brute(mesh, rays), 0u);
}

TEST(BvhHits, IntervalLimits) {
  const Mesh mesh = random_soup(41, 800, 0.3f);
  const Blob scene = make_scene(mesh);
  std::vector<Ray> rays;
  for (const Ray& ray : random_rays(3, 400, bounds_of(mesh), 1.0f)) {
    const Hit hit = brute_closest(view_of(scene), ray);
    if (hit.id == kMiss) continue;
    const float before = std::nextafter(hit.t, -kInfinity), after = std::nextafter(hit.t, kInfinity);
    for (const float tmin : {0.0f, before, hit.t, after}) {
      for (const float tmax : {before, hit.t, after, kFarAway}) rays.push_back({ray.o, tmin, ray.d, tmax});
    }
    rays.push_back({ray.o, -kFarAway, ray.d, kFarAway});
    rays.push_back({ray.o, -kFarAway, ray.d, 0.0f});
  }
  EXPECT_GT(expect_like_brute(mesh, rays), 1000u);
}

TEST(BvhHits, AHitAtExactlyTmaxCounts) {
  const Mesh mesh = quad_grid(8);
  const Blob scene = make_scene(mesh);
  const BuiltStructure built = bvh::build(view_of(scene), {});
  Ray ray{{0.1f, 0.2f, 2.0f}, 0.0f, {0, 0, -1}, kFarAway};
  const Hit hit = brute_closest(view_of(scene), ray);
  ASSERT_NE(hit.id, kMiss);
  ray.tmax = hit.t;
  EXPECT_TRUE(same(bvh_closest(built.blob.data(), view_of(scene), ray), hit));
  EXPECT_TRUE(bvh_any(built.blob.data(), view_of(scene), ray));
  ray.tmax = std::nextafter(hit.t, 0.0f);
  EXPECT_EQ(bvh_closest(built.blob.data(), view_of(scene), ray).id, kMiss);
  EXPECT_FALSE(bvh_any(built.blob.data(), view_of(scene), ray));
}

TEST(BvhHits, ManyIdenticalTriangles) {
  const Mesh mesh(100000, triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  const std::vector<Ray> rays = {{{0.2f, 0.2f, 1}, 0, {0, 0, -1}, 10}, {{0.7f, 0.7f, 1}, 0, {0, 0, -1}, 10}};
  EXPECT_EQ(expect_like_brute(mesh, rays), 1u);
  const Blob scene = make_scene(mesh);
  const BuiltStructure built = bvh::build(view_of(scene), {});
  EXPECT_EQ(bvh_closest(built.blob.data(), view_of(scene), rays[0]).id, 0u);
  EXPECT_LE(built.stats.max_depth, 20u);
}

}  // namespace
}  // namespace raywalk::test
