// One ray and one triangle: the filtered oracle against rational numbers, on input that is hard on the filter.
#include <gtest/gtest.h>

#include "tests/accuracy/rational.h"
#include "tests/support/meshes.h"

namespace raywalk::oracle {
namespace {

using test::Mesh;
using test::Random;

constexpr float kInf = std::numeric_limits<float>::infinity();

float scaled(float a, int exponent) {
  return std::ldexp(a, exponent);
}
Vec3 scaled(Vec3 a, int exponent) {
  return {scaled(a.x, exponent), scaled(a.y, exponent), scaled(a.z, exponent)};
}

/// How `classify` differs from rational numbers; empty when it does not.
std::string difference(const Ray& ray, const Corners& triangle) {
  const Crossing found = classify(ray, triangle);
  const Rational3 o = rational(ray.o), d = rational(ray.d);
  const RationalCrossing expected = rational_crossing(o, d, triangle);
  if (found.position != expected.position) return "position";

  const Rational3 corner[3] = {rational(triangle.a), rational(triangle.b), rational(triangle.c)};
  mpq_class reach = 0, least = -1;
  for (u32 i = 0; i < 3; ++i) {
    for (u32 axis = 0; axis < 3; ++axis) reach = std::max(reach, mpq_class(abs(corner[i][axis] - o[axis])));
    const mpq_class distance = squared_line_distance(o, d, corner[i], corner[(i + 1) % 3]);
    if (least < 0 || distance < least) least = distance;
  }
  const mpq_class limit = reach * reach * mpq_class(kNear * kNear);
  const Rational3 n = cross(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
  const bool degenerate = dot(n, n) == 0;
  if (degenerate && found.near) return "near a degenerate triangle";
  if (!degenerate && abs(least - limit) > limit * mpq_class(2e-8) && found.near != (least < limit)) return "near";

  if (!expected.t) return "";
  if (found.t != nearest_float(*expected.t) || bits_of(found.t) == bits_of(-0.0f)) return "t";
  const double ulp = ulp_at(expected.t->get_d());
  if (abs(mpq_class(found.precise_t) - *expected.t) > mpq_class(ulp) / 4096) return "precise t";
  if (mpq_class(found.low) > *expected.t || mpq_class(found.high) < *expected.t) return "low and high";
  for (const float bound : {found.t, std::nextafter(found.t, 0.0f), 0.0f, ray.tmin}) {
    if (is_finite(bound) && compare_distance(ray, triangle, bound) != sgn(*expected.t - mpq_class(bound)))
      return "order";
  }
  return "";
}

/// All pairs that differ, counted by what differs.
class Tally {
 public:
  void check(const Ray& ray, const Corners& triangle) {
    const std::string what = difference(ray, triangle);
    met_ += classify(ray, triangle).met();
    ++pairs_;
    if (what.empty()) return;
    if (++wrong_ <= 3) {
      ADD_FAILURE() << what << " differs: o " << ray.o.x << ' ' << ray.o.y << ' ' << ray.o.z << " d " << ray.d.x << ' '
                    << ray.d.y << ' ' << ray.d.z;
    }
  }
  void expect_met(int per_cent) const { EXPECT_GE(100 * met_, per_cent * pairs_); }

 private:
  int pairs_ = 0, met_ = 0, wrong_ = 0;
};

Corners random_triangle(Random& random) {
  const Vec3 lo{-1, -1, -1}, hi{1, 1, 1};
  return test::triangle(random.in_box(lo, hi), random.in_box(lo, hi), random.in_box(lo, hi));
}

/// From anywhere at a point of the triangle: a vertex, on an edge or inside.
Ray aimed(Random& random, const Corners& t) {
  const Vec3 lo{-3, -3, -3}, hi{3, 3, 3};
  const float s = random.uniform(), r = random.uniform() * (1.0f - s);
  const Vec3 targets[3] = {t.a, t.a * s + t.b * (1.0f - s), t.a * s + t.b * r + t.c * (1.0f - s - r)};
  return test::ray_towards(random.in_box(lo, hi), targets[random.below(3)]);
}

TEST(Exact, RandomAndAimedRays) {
  Random random(1);
  Tally aimed_rays;
  for (int i = 0; i < 3000; ++i) {
    const Corners t = random_triangle(random);
    aimed_rays.check(aimed(random, t), t);
    const Corners other = random_triangle(random);
    EXPECT_EQ(difference(aimed(random, t), other), "");
  }
  aimed_rays.expect_met(40);
}

TEST(Exact, LatticesAreFullOfZeros) {
  Random random(2);
  Tally tally;
  const auto point = [&](u32 size) {
    const auto whole = [&] { return static_cast<float>(random.below(size)); };
    return Vec3{whole(), whole(), whole()};
  };
  for (int i = 0; i < 6000; ++i) {
    const u32 size = 2 + random.below(4);
    const Corners t = test::triangle(point(size), point(size), point(size));  // degenerate ones too
    const Ray ray = test::ray_towards(point(size) + Vec3{0, 0, 4}, point(size));
    if (is_valid(ray)) tally.check(ray, t);
  }
  tally.expect_met(10);
}

TEST(Exact, AllScales) {
  Random random(3);
  Tally tally;
  for (int i = 0; i < 3000; ++i) {
    const Corners unit = random_triangle(random);
    const Ray ray = aimed(random, unit);
    const int size = static_cast<int>(random.below(276)) - 148, d_size = static_cast<int>(random.below(270)) - 144;
    const Corners t = test::triangle(scaled(unit.a, size), scaled(unit.b, size), scaled(unit.c, size));
    const Ray moved{scaled(ray.o, size - (size > 125 ? 2 : 0)), 0.0f, scaled(ray.d, std::min(d_size, 124)), 1.0f};
    if (is_valid(moved) && is_finite(t)) tally.check(moved, t);
  }
  tally.expect_met(10);
}

TEST(Exact, MixedScales) {
  Random random(4);
  Tally tally;
  for (int i = 0; i < 1000; ++i) {
    const auto any = [&] { return scaled(random.uniform(-1, 1), static_cast<int>(random.below(270)) - 145); };
    const auto some = [&](int spread) {
      return scaled(random.uniform(-1, 1), -static_cast<int>(random.below(static_cast<u32>(spread))));
    };
    const Corners wild = test::triangle({any(), any(), any()}, {any(), any(), any()}, {any(), any(), any()});
    tally.check({{any(), any(), any()}, 0.0f, {any(), any(), any()}, 1.0f}, wild);
    const auto point = [&] { return Vec3{some(30), some(30), some(30)}; };
    const Corners t = test::triangle(point(), point(), point());
    tally.check(test::ray_towards(point(), fma(0.5f, t.a, 0.5f * t.b)), t);
  }
}

TEST(Exact, OffsetsAndSlivers) {
  Random random(5);
  Tally tally;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 offset = random.in_box({-1e6f, -1e6f, -1e6f}, {1e6f, 1e6f, 1e6f});
    Corners t = random_triangle(random);
    t = test::triangle(t.a + offset, t.b + offset, t.c + offset);
    tally.check(test::ray_towards(offset + random.in_box({-5, -5, -5}, {5, 5, 5}), 0.5f * t.a + 0.5f * t.b), t);
    tally.check(test::ray_towards(random.in_box({-5, -5, -5}, {5, 5, 5}), t.c), t);
  }
  for (const Corners& t : test::slivers(6, 2000)) {
    tally.check(aimed(random, t), t);
    tally.check(test::ray_towards(random.in_box({-2, -2, -2}, {2, 2, 2}), fma(0.3f, t.c - t.a, t.a)), t);
  }
}

TEST(Exact, RaysFromTheSurfaceAndInThePlane) {
  Random random(7);
  Tally tally;
  for (int i = 0; i < 2000; ++i) {
    const Corners t = random_triangle(random);
    const Vec3 on = 0.25f * t.a + 0.25f * t.b + 0.5f * t.c;
    tally.check({on, 0.0f, random.direction(), 1.0f}, t);
    tally.check({on, 0.0f, t.b - t.a, 1.0f}, t);
    tally.check({t.a, 0.0f, t.c - t.b, 1.0f}, t);
    const Corners flat = test::triangle({t.a.x, t.a.y, 0}, {t.b.x, t.b.y, 0}, {t.c.x, t.c.y, 0});
    tally.check({{on.x, on.y, 0}, 0.0f, {t.a.x, t.b.y, -0.0f}, 1.0f}, flat);
    tally.check({{on.x, on.y, 1}, 0.0f, {0, 0, -1}, 1.0f}, flat);
  }
}

TEST(Exact, OrderOfDistances) {
  Random random(8);
  for (int i = 0; i < 1500; ++i) {
    const Corners a = random_triangle(random);
    Corners b = random_triangle(random);
    if (i % 3 == 0) b = test::triangle(a.b, a.c, a.a);
    if (i % 3 == 1) b = test::triangle(a.a, a.b, b.c);
    const float s = random.uniform();
    const Ray ray = test::ray_towards(random.in_box({-3, -3, -3}, {3, 3, 3}), a.a * s + a.b * (1.0f - s));
    const RationalCrossing first = rational_crossing(rational(ray.o), rational(ray.d), a);
    const RationalCrossing second = rational_crossing(rational(ray.o), rational(ray.d), b);
    if (first.t && second.t) {
      EXPECT_EQ(compare_distances(ray, a, b), sgn(*first.t - *second.t));
    }
  }
}

/// The promise of `near`, `low` and `high`: whatever a moved ray meets was announced.
TEST(Exact, MovedRaysMeetWhatIsTouched) {
  Random random(9);
  int met = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    Corners t = random_triangle(random);
    if (i % 2) t.c = fma(1e-6f, t.c, 0.5f * t.a + 0.5f * t.b);
    const Ray ray = aimed(random, t);
    const Crossing found = classify(ray, t);
    const Vec3 to = random.direction() * (0.999f * static_cast<float>(found.radius));
    const Rational3 o = along(rational(ray.o), rational(to), 1);
    const RationalCrossing moved = rational_crossing(o, rational(ray.d), t);
    if (!moved.t) continue;
    ++met;
    outside += !found.met();
    EXPECT_TRUE(found.touched());
    EXPECT_TRUE(mpq_class(found.low) <= *moved.t);
    EXPECT_TRUE(mpq_class(found.high) >= *moved.t);
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(outside, 100);
}

TEST(Exact, NeverMet) {
  const Corners good = test::triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Ray ray{{0.25f, 0.25f, 1}, 0.0f, {0, 0, -1}, 10.0f};
  EXPECT_EQ(classify(ray, good).position, Position::inside);
  EXPECT_EQ(classify(ray, good).t, 1.0f);
  for (const float bad : {kInf, -kInf, std::nanf("")}) {
    EXPECT_FALSE(classify(ray, test::triangle({0, 0, bad}, {1, 0, 0}, {0, 1, 0})).touched());
    EXPECT_FALSE(classify({{0, bad, 1}, 0, {0, 0, -1}, 10}, good).touched());
    EXPECT_FALSE(classify({ray.o, 0, {0, 0, bad}, 10}, good).touched());
    EXPECT_FALSE(classify({ray.o, bad, ray.d, 10}, good).touched());
    EXPECT_FALSE(classify({ray.o, 0, ray.d, bad}, good).touched());
  }
  EXPECT_FALSE(classify({ray.o, 0, {0, -0.0f, 0}, 10}, good).touched());
  // Degenerate: a line, a point, a repeated vertex.
  const Ray down{{0.5f, 0, 1}, 0, {0, 0, -1}, 10};
  EXPECT_FALSE(classify(down, test::triangle({0, 0, 0}, {1, 0, 0}, {0.5f, 0, 0})).touched());
  EXPECT_FALSE(classify(down, test::triangle({0.5f, 0, 0}, {0.5f, 0, 0}, {0.5f, 0, 0})).touched());
  EXPECT_FALSE(classify(down, test::triangle({0, 0, 0}, {0, 0, 0}, {1, 0, 0})).touched());
  // In the plane: near when an edge is touched.
  const Crossing flat = classify({{-1, 0.25f, 0}, 0, {1, 0, 0}, 10}, good);
  EXPECT_EQ(flat.position, Position::coplanar);
  EXPECT_TRUE(flat.near);
  EXPECT_FALSE(flat.met());
  EXPECT_FALSE(classify({{-1, 2, 0}, 0, {1, 0, 0}, 10}, good).touched());
}

TEST(Exact, KnownAnswers) {
  // A quad split on its diagonal; the ray runs exactly through the diagonal.
  const Corners lower = test::triangle({-5, -5, 0}, {5, -5, 0}, {5, 5, 0});
  const Corners upper = test::triangle({-5, -5, 0}, {5, 5, 0}, {-5, 5, 0});
  const Ray diagonal = test::ray_towards({0, 0, 10}, {3.375f, 3.375f, 0});
  for (const Corners& t : {lower, upper}) {
    EXPECT_EQ(classify(diagonal, t).position, Position::edge);
    EXPECT_TRUE(classify(diagonal, t).near);
    EXPECT_EQ(classify(diagonal, t).t, 1.0f);
  }
  EXPECT_EQ(compare_distances(diagonal, lower, upper), 0);

  struct Case {
    Vec3 target;
    Position position;
    bool near;
  };
  const Case cases[] = {{{1, 0, 0}, Position::inside, false},        {{0, 1, 0}, Position::outside, false},
                        {{5, -5, 0}, Position::vertex, true},        {{5, 1, 0}, Position::edge, true},
                        {{1.00001f, 1, 0}, Position::inside, true},  {{1, 1.00001f, 0}, Position::outside, true},
                        {{1.0001f, 1, 0}, Position::inside, false},  {{5.0001f, 0, 0}, Position::outside, false},
                        {{5.000005f, 0, 0}, Position::outside, true}};
  for (const Case& c : cases) {
    const Crossing found = classify({c.target + Vec3{0, 0, 10}, 0, {0, 0, -1}, 20}, lower);
    EXPECT_EQ(found.position, c.position) << c.target.x << ' ' << c.target.y;
    EXPECT_EQ(found.near, c.near) << c.target.x << ' ' << c.target.y;
  }
  // Beyond the floats, and below them.
  const Corners far = test::triangle({-1e38f, -1e38f, 3e38f}, {2e38f, -1e38f, 3e38f}, {-1e38f, 2e38f, 3e38f});
  EXPECT_EQ(classify({{0, 0, 0}, 0, {0, 0, 1}, 1}, far).t, 3e38f);
  EXPECT_EQ(classify({{0, 0, 0}, 0, {0, 0, 0.5f}, 1}, far).t, kInf);
  EXPECT_EQ(classify({{0, 0, 0}, 0, {0, 0, -0.5f}, 1}, far).t, -kInf);
  const Corners tiny = test::triangle({-0x1p-148f, -0x1p-148f, 0x1p-149f}, {0x1p-147f, -0x1p-148f, 0x1p-149f},
                                      {-0x1p-148f, 0x1p-147f, 0x1p-149f});
  EXPECT_EQ(classify({{0, 0, 0}, 0, {0, 0, 1}, 1}, tiny).t, 0x1p-149f);
  EXPECT_EQ(classify({{0, 0, 0}, 0, {0, 0, 2}, 1}, tiny).t, 0.0f);  // half a unit, to even
  EXPECT_EQ(classify({{0, 0, 0}, 0, {0, 0, 0x1p-149f}, 1}, tiny).t, 1.0f);
}

TEST(Exact, TheFilterDecidesNearlyAll) {
  const Mesh mesh = test::icosphere(4, 2.0f);
  std::vector<Ray> rays = test::random_rays(1, 40, {{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}}, 1.0f);
  for (const Ray& ray : test::edge_rays(2, 40, mesh)) rays.push_back(ray);
  for (const Ray& ray : test::vertex_rays(3, 40, mesh)) rays.push_back(ray);
  u64 by_integers = 0, touched = 0, touched_by_integers = 0;
  for (const Ray& ray : rays) {
    for (const Corners& t : mesh) {
      const Crossing found = classify(ray, t);
      by_integers += found.by_integers;
      touched += found.touched();
      touched_by_integers += found.touched() && found.by_integers;
    }
  }
  EXPECT_LE(200 * by_integers, rays.size() * mesh.size());
  EXPECT_LE(20 * touched_by_integers, touched);
}

TEST(Exact, UlpAt) {
  EXPECT_EQ(ulp_at(1.0), 0x1p-23);
  EXPECT_EQ(ulp_at(-1.999), 0x1p-23);
  EXPECT_EQ(ulp_at(0.0), 0x1p-149);
  EXPECT_EQ(ulp_at(1e-300), 0x1p-149);
  EXPECT_EQ(ulp_at(0x1.8p200), 0x1p177);
}

}  // namespace
}  // namespace raywalk::oracle
