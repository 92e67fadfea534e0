// Triangle tests against the exact oracle: the exact one never differs, the others where they promise nothing are only
// measured.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/query.h"
#include "server/accuracy/oracle/exact.h"
#include "tests/support/meshes.h"

namespace raywalk::test {
namespace {

using oracle::Crossing;
using oracle::Position;

struct Meeting {
  bool met;
  float t, u, v;
};

template <class Intersector>
Meeting meet(const Ray& ray, const Corners& triangle) {
  Meeting m{false, 0, 0, 0};
  if constexpr (std::is_same_v<typename RecordOf<Intersector>::Type, Transform>) {
    m.met = intersect(Intersector(ray), transform_of(triangle), m.t, m.u, m.v);
  } else {
    m.met = intersect(Intersector(ray), triangle, m.t, m.u, m.v);
  }
  return m;
}

/// How often a test differs from the oracle.
struct Differences {
  u64 pairs = 0, inside = 0, on_border = 0, false_hits = 0, false_misses = 0;
};

template <class Intersector>
Differences compare(const Mesh& mesh, const std::vector<Ray>& rays) {
  Differences all;
  for (const Ray& ray : rays) {
    if (!is_valid(ray)) continue;
    for (const Corners& triangle : mesh) {
      const Crossing crossing = oracle::classify(ray, triangle);
      const bool met = meet<Intersector>(ray, triangle).met;
      const bool is_inside = crossing.position == Position::inside && std::isfinite(crossing.t);
      ++all.pairs;
      all.inside += is_inside;
      all.on_border += crossing.position == Position::edge || crossing.position == Position::vertex;
      all.false_hits += met && !is_met(crossing.position);
      all.false_misses += !met && is_inside;
    }
  }
  return all;
}

void append(std::vector<Ray>& rays, const std::vector<Ray>& more) {
  rays.insert(rays.end(), more.begin(), more.end());
}

std::vector<Ray> hard_rays(const Mesh& mesh, u32 count, u32 seed) {
  std::vector<Ray> rays = random_rays(seed, count, bounds_of(mesh));
  append(rays, edge_rays(seed, count, mesh));
  append(rays, vertex_rays(seed, count, mesh));
  append(rays, axis_rays(seed, count, mesh));
  return rays;
}

/// Whole origins, and directions of -3 to 3.
std::vector<Ray> lattice_rays(u32 seed, u32 count, u32 size) {
  Random random(seed);
  const auto whole = [&](u32 n) { return static_cast<float>(random.below(n)); };
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Ray ray{{whole(size), whole(size), whole(size)}, 0, {whole(7) - 3, whole(7) - 3, whole(7) - 3}, kFarAway};
    if (is_valid(ray)) rays.push_back(ray);
  }
  return rays;
}

void expect_exact(const Mesh& mesh, const std::vector<Ray>& rays, u64 fewest_inside) {
  const Differences found = compare<Exact>(mesh, rays);
  EXPECT_EQ(found.false_hits, 0u);
  EXPECT_EQ(found.false_misses, 0u);
  EXPECT_GE(found.inside, fewest_inside) << found.pairs << " pairs, " << found.on_border << " on borders";
}

TEST(ExactTest, EdgesAndVerticesOfSpheresAnywhere) {
  for (const float offset : {0.0f, 1e3f, 1e6f}) {
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
      SCOPED_TRACE(testing::Message() << "offset " << offset << " scale " << scale);
      const Mesh mesh = transformed(icosphere(2), scale, {offset, -offset, 0.5f * offset});
      expect_exact(mesh, hard_rays(mesh, 60, 3), offset / scale > 1e5f ? 0 : 60);
    }
  }
}

TEST(ExactTest, Lattices) {
  const Mesh mesh = integer_lattice(4, 300, 4);
  const std::vector<Ray> rays = lattice_rays(5, 600, 5);
  const Differences found = compare<Exact>(mesh, rays);
  EXPECT_EQ(found.false_hits + found.false_misses, 0u);
  EXPECT_GT(found.inside, 2000u);
  EXPECT_GT(found.on_border, 2000u);
}

TEST(ExactTest, SliversAndSoups) {
  for (const Mesh& mesh : {slivers(2, 200), random_soup(7, 200, 0.5f), random_soup(8, 200, 1e-4f)}) {
    expect_exact(mesh, hard_rays(mesh, 80, 9), 20);
  }
}

TEST(ExactTest, AllSizesThatFloatsHave) {
  for (const float scale : {0x1p-130f, 0x1p-100f, 0x1p-60f, 0x1p60f, 0x1p100f, 0x1p125f}) {
    SCOPED_TRACE(scale);
    const Mesh mesh = transformed(icosphere(1), scale, {0, 0, 0});
    std::vector<Ray> rays = hard_rays(mesh, 50, 4);
    for (const Ray& ray : hard_rays(icosphere(1), 50, 6)) {
      const Vec3 o = ray.o * scale;
      if (is_finite(o)) rays.push_back({o, 0, ray.d, kFarAway});
    }
    expect_exact(mesh, rays, 50);
  }
}

TEST(ExactTest, OriginsOnTheTriangles) {
  const Mesh mesh = icosphere(1);
  Random random(3);
  std::vector<Ray> rays;
  for (const Corners& t : mesh) {
    for (const Vec3 o : {t.a, 0.5f * t.b + 0.5f * t.c, 0.25f * t.a + 0.25f * t.b + 0.5f * t.c}) {
      rays.push_back({o, 0, random.direction(), kFarAway});
      rays.push_back({o, 0, t.b - t.a, kFarAway});
    }
  }
  expect_exact(mesh, rays, 100);
}

/// Of a closed surface: each line crosses it an even number of times, wherever it runs and begins; unless it begins in
/// a triangle in whose plane it runs, which it then misses by definition.
void expect_closed(const Mesh& mesh, const std::vector<Ray>& rays) {
  u64 odd = 0, crossings = 0, compared = 0;
  for (const Ray& ray : rays) {
    u32 met = 0;
    bool coplanar = false;
    for (const Corners& triangle : mesh) {
      met += meet<Exact>(ray, triangle).met;
      coplanar |= oracle::classify(ray, triangle).position == Position::coplanar;
    }
    if (coplanar) continue;
    ++compared;
    odd += met % 2;
    crossings += met;
  }
  EXPECT_EQ(odd, 0u) << "of " << compared;
  EXPECT_GT(compared, rays.size() / 2);
  EXPECT_GT(crossings, compared / 2);
}

TEST(ExactTest, EachEdgeAndVertexHasOneOwner) {
  const Mesh sphere = icosphere(2, 2.0f);
  expect_closed(sphere, hard_rays(sphere, 300, 11));
  const Mesh far = transformed(icosphere(2), 1.0f, {1e6f, -1e6f, 5e5f});
  expect_closed(far, hard_rays(far, 300, 12));

  const Mesh box = subdivided_box(8, 0.0f, 8.0f);
  std::vector<Ray> rays;
  for (const Ray& ray : lattice_rays(13, 3000, 9)) {
    // A line that runs along a face from within it may meet it or not.
    bool along_face = false;
    for (u32 axis = 0; axis < 3; ++axis) along_face |= ray.d[axis] == 0 && (ray.o[axis] == 0 || ray.o[axis] == 8);
    if (!along_face) rays.push_back(ray);
  }
  expect_closed(box, rays);

  for (const Ray& ray : rays) {
    const bool inside = largest(magnitude(ray.o - Vec3{4, 4, 4})) < 4;
    u32 ahead = 0;
    for (const Corners& triangle : box) {
      const Meeting m = meet<Exact>(ray, triangle);
      ahead += m.met && m.t > 0;
    }
    if (inside) {
      EXPECT_EQ(ahead, 1u);
    }
  }
}

TEST(ExactTest, OriginsOnVerticesAndEdgesKeepTheSurfaceClosed) {
  const Mesh mesh = subdivided_box(4, 0.0f, 4.0f);
  std::vector<Ray> rays;
  for (const Ray& ray : lattice_rays(17, 2000, 5)) {
    const bool in_no_plane = ray.d.x != 0 && ray.d.y != 0 && ray.d.z != 0;
    if (in_no_plane) rays.push_back(ray);
  }
  expect_closed(mesh, rays);
}

TEST(ExactTest, DistanceIsRoundedOnce) {
  double worst = 0;
  u64 hits = 0;
  for (const float offset : {0.0f, 1e4f}) {
    const Mesh mesh = transformed(icosphere(2), 1.0f, {offset, -offset, offset});
    for (const Ray& ray : hard_rays(mesh, 200, 21)) {
      for (const Corners& triangle : mesh) {
        const Meeting m = meet<Exact>(ray, triangle);
        if (!m.met) continue;
        ++hits;
        const Crossing crossing = oracle::classify(ray, triangle);
        const Double3 n = cross(between(triangle.a, triangle.b), between(triangle.a, triangle.c));
        const Double3 d = to_double(ray.d);
        const bool steep = std::abs(dot(d, n)) > 1e-3 * std::sqrt(dot(d, d) * dot(n, n));
        const bool ahead = std::abs(crossing.precise_t) > 1e-3;
        if (steep && ahead)
          worst = std::max(worst, std::abs(double{m.t} - crossing.precise_t) / oracle::ulp_at(crossing.precise_t));
        EXPECT_TRUE(m.u >= 0 && m.v >= 0 && m.u + m.v <= 1.000001f);
      }
    }
  }
  EXPECT_GT(hits, 500u);
  EXPECT_LE(worst, 0.51);
}

TEST(ExactTest, GrazingHitsStayBetweenTheCorners) {
  // Hard case 27: edges of 11.2, 9.7 and 1.4, seen at half a degree and less.
  const Mesh mesh = {triangle({0, 0, 0}, {11.2f, 0, 0}, {9.6f, 1.38f, 0})};
  for (const float angle : {1e-2f, 1e-5f, 1e-7f, 1e-12f, 1e-30f}) {
    for (u32 i = 0; i < 200; ++i) {
      const float y = 0.003f * static_cast<float>(i);
      const Ray ray{{-50, y, 60 * angle}, 0, {1, 0, -angle}, kFarAway};
      const Meeting m = meet<Exact>(ray, mesh[0]);
      ASSERT_EQ(m.met, oracle::classify(ray, mesh[0]).met()) << angle << ' ' << y;
      if (m.met) {
        EXPECT_NEAR(m.t, 60.0f, 1e-5f * 60.0f) << angle;
      }
    }
  }
}

TEST(ExactTest, NeverMeetsWhatIsNoTriangle) {
  const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
  const std::vector<Ray> rays = hard_rays(icosphere(0), 100, 5);
  for (const float bad : {nan, inf, -inf}) {
    for (u32 which = 0; which < 9; ++which) {
      Mesh mesh = icosphere(0);
      for (Corners& t : mesh) {
        Vec3& corner = which / 3 == 0 ? t.a : which / 3 == 1 ? t.b : t.c;
        (which % 3 == 0 ? corner.x : which % 3 == 1 ? corner.y : corner.z) = bad;
      }
      const Differences found = compare<Exact>(mesh, rays);
      EXPECT_EQ(found.false_hits, 0u) << bad << ' ' << which;
      EXPECT_EQ(found.inside, 0u);
    }
  }
  const Vec3 p{1, 2, 3}, q{2, 4, 6};
  const Mesh points = {triangle(p, p, p), triangle(p, p, q), triangle(p, q, 0.5f * p + 0.5f * q)};
  EXPECT_EQ(compare<Exact>(points, hard_rays(points, 100, 6)).false_hits, 0u);
}

template <class Intersector>
class OtherTests : public testing::Test {};
using Others = testing::Types<Watertight, MoellerTrumbore, MoellerTrumboreDouble, BaldwinWeber>;
TYPED_TEST_SUITE(OtherTests, Others);

TYPED_TEST(OtherTests, AgreeWithTheOracleAwayFromEdges) {
  const Mesh mesh = random_soup(31, 200, 1.0f);
  u64 compared = 0, wrong = 0;
  for (const Ray& ray : random_rays(32, 300, bounds_of(mesh))) {
    for (const Corners& triangle : mesh) {
      const Crossing crossing = oracle::classify(ray, triangle);
      if (crossing.near) continue;
      const Meeting m = meet<TypeParam>(ray, triangle);
      // Baldwin and Weber's coefficients are large for slender triangles: a few more rays are near for them.
      wrong += m.met != crossing.met() || (m.met && std::abs(m.t - crossing.precise_t) > 1e-3);
      ++compared;
    }
  }
  EXPECT_GT(compared, 59000u);
  EXPECT_LE(wrong, 1u);
}

TYPED_TEST(OtherTests, AreMeasuredAtEdgesAndVertices) {
  for (const float offset : {0.0f, 1e2f, 1e4f}) {
    const Mesh mesh = transformed(icosphere(2), 1.0f, {offset, offset, -offset});
    std::vector<Ray> rays = edge_rays(41, 1000, mesh);
    append(rays, vertex_rays(42, 1000, mesh));
    const Differences found = compare<TypeParam>(mesh, rays);
    EXPECT_GT(found.inside, 100u);
    std::printf("  offset %-6g %llu met inside: %llu false misses, %llu false hits\n", offset, found.inside,
                found.false_misses, found.false_hits);
  }
}

TYPED_TEST(OtherTests, NeverMeetDegenerateOrNonFiniteTriangles) {
  const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
  const Vec3 p{1, 0.5f, 0.25f}, q{-1, 1, 0};
  const Mesh mesh = {triangle(p, p, p),
                     triangle(p, p, q),
                     triangle(p, q, p),
                     triangle({nan, 0, 0}, p, q),
                     triangle(p, {0, inf, 0}, q),
                     triangle(p, q, {0, 0, -inf}),
                     triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2})};
  const Mesh around = icosphere(0);
  for (const Ray& ray : hard_rays(around, 200, 51)) {
    for (const Corners& triangle : mesh) EXPECT_FALSE(meet<TypeParam>(ray, triangle).met);
  }
}

}  // namespace
}  // namespace raywalk::test
