// Verdicts on answers made by hand, one of each kind at least.
#include <gtest/gtest.h>

#include <limits>

#include "kernels/triangle/moeller_trumbore.h"
#include "kernels/triangle/watertight.h"
#include "server/accuracy/oracle/figures.h"
#include "server/accuracy/oracle/scene_oracle.h"
#include "tests/support/meshes.h"

namespace raywalk::oracle {
namespace {

using test::Mesh;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Judge {
 public:
  explicit Judge(const Mesh& mesh) : scene_(test::make_scene(mesh)), oracle_(test::view_of(scene_)) {}

  Verdict of(const Ray& ray, u32 id, float t = 1.0f) const { return oracle_.judge(ray, {t, id, 0, 0}).verdict; }
  Verdict of_miss(const Ray& ray) const { return of(ray, kMiss, ray.tmax); }
  Verdict of_occluded(const Ray& ray, bool given) const { return oracle_.judge_occluded(ray, given).verdict; }
  const SceneOracle& oracle() const { return oracle_; }

 private:
  Blob scene_;
  SceneOracle oracle_;
};

/// Straight down on (x, y) from z = 10.
Ray down(float x, float y, float tmax = 100.0f) {
  return {{x, y, 10}, 0, {0, 0, -1}, tmax};
}

/// The quad [-5, 5]^2 at height z, split on y = x: the first triangle has y < x.
Mesh quad(float z) {
  return {test::triangle({-5, -5, z}, {5, -5, z}, {5, 5, z}), test::triangle({-5, -5, z}, {5, 5, z}, {-5, 5, z})};
}

/// Two quads: 0 and 1 at z = 0, 2 and 3 at z = -1.
Mesh two_quads() {
  Mesh mesh = quad(0);
  test::append(mesh, quad(-1));
  return mesh;
}

TEST(Verdicts, Strict) {
  const Judge judge(two_quads());
  const Ray ray = down(3, 1);
  EXPECT_EQ(judge.oracle().closest(ray).ray_class, RayClass::strict);
  EXPECT_EQ(judge.of(ray, 0, 10), Verdict::right);
  EXPECT_EQ(judge.of(ray, 2, 11), Verdict::false_miss);
  EXPECT_EQ(judge.of_miss(ray), Verdict::false_miss);
  EXPECT_EQ(judge.of(ray, 1, 10), Verdict::wrong_id);
  EXPECT_EQ(judge.of(ray, 3, 11), Verdict::wrong_id);
  EXPECT_EQ(judge.of(ray, 4, 10), Verdict::wrong_id);
  EXPECT_EQ(judge.of(ray, 0x80000000u, kNan), Verdict::wrong_id);
  EXPECT_EQ(judge.of_occluded(ray, true), Verdict::right);
  EXPECT_EQ(judge.of_occluded(ray, false), Verdict::false_miss);
  const Ray beside = down(6, 1);
  EXPECT_EQ(judge.of_miss(beside), Verdict::right);
  EXPECT_EQ(judge.of(beside, 0, 10), Verdict::false_hit);
  EXPECT_EQ(judge.of(beside, 77, 10), Verdict::false_hit);
  EXPECT_EQ(judge.of_occluded(beside, true), Verdict::false_hit);
  EXPECT_EQ(judge.of_occluded(beside, false), Verdict::right);
}

TEST(Verdicts, ErrorOfT) {
  const Judge judge(two_quads());
  const auto ulps = [&](float t) { return judge.oracle().judge(down(3, 1), {t, 0, 0, 0}).t_ulps; };
  EXPECT_EQ(ulps(10.0f), 0.0);
  EXPECT_EQ(ulps(std::nextafter(10.0f, 11.0f)), 1.0);
  EXPECT_EQ(ulps(10.0f - 0x1p-17f), 8.0);
  EXPECT_EQ(ulps(kNan), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(judge.oracle().judge(down(3, 1), {11, 2, 0, 0}).t_ulps);
  EXPECT_TRUE(judge.oracle().judge(down(3, 1), {10, 0, 0, 0}).well_conditioned);
  EXPECT_FALSE(judge.oracle().judge(test::ray_towards({-90, 1, 1}, {3, 1, 0}), {1, 0, 0, 0}).well_conditioned);
  EXPECT_FALSE(judge.oracle().judge({{3, 1, 0.5f}, 0, {0, 0, -1}, 1}, {0.5f, 0, 0, 0}).well_conditioned);
  EXPECT_FALSE(judge.oracle().judge(down(6, 1), {100, kMiss, 0, 0}).t_ulps);
}

TEST(Verdicts, OnTheDiagonalOfAQuad) {
  const Judge judge(two_quads());
  const Ray ray = test::ray_towards({0, 0, 10}, {3.375f, 3.375f, 0});
  const Answer answer = judge.oracle().closest(ray);
  EXPECT_EQ(answer.hit.id, 0u);
  EXPECT_EQ(answer.hit.t, 1.0f);
  EXPECT_EQ(answer.ray_class, RayClass::boundary);
  ASSERT_EQ(answer.ties.size(), 2u);
  EXPECT_EQ(answer.ties[1].id, 1u);
  EXPECT_EQ(answer.ties[1].position, Position::edge);
  EXPECT_EQ(judge.of(ray, 0), Verdict::right);
  EXPECT_EQ(judge.of(ray, 1), Verdict::boundary);
  EXPECT_EQ(judge.of(ray, 2, 1.1f), Verdict::leak);
  EXPECT_EQ(judge.of_miss(ray), Verdict::leak);
  EXPECT_EQ(judge.of_occluded(ray, false), Verdict::leak);
}

TEST(Verdicts, NearTheDiagonalOfAQuad) {
  const Judge judge(two_quads());
  const Ray ray = down(1.00001f, 1);
  EXPECT_EQ(judge.oracle().closest(ray).ray_class, RayClass::near);
  EXPECT_EQ(judge.of(ray, 0, 10), Verdict::right);
  EXPECT_EQ(judge.of(ray, 1, 10), Verdict::near);
  EXPECT_EQ(judge.of(ray, 3, 11), Verdict::leak);
  EXPECT_EQ(judge.of_miss(ray), Verdict::leak);
  EXPECT_EQ(judge.of_occluded(ray, false), Verdict::leak);
}

TEST(Verdicts, BordersAreOpen) {
  const Judge judge(quad(0));
  const Ray on = down(5, 1), within = down(4.999997f, 1), beyond = down(5.000003f, 1), corner = down(5, 5);
  EXPECT_EQ(judge.of(on, 0, 10), Verdict::right);
  EXPECT_EQ(judge.of_miss(on), Verdict::boundary);
  EXPECT_EQ(judge.of_occluded(on, false), Verdict::boundary);
  EXPECT_EQ(judge.of_miss(corner), Verdict::boundary);
  EXPECT_EQ(judge.of(corner, 1, 10), Verdict::boundary);
  EXPECT_EQ(judge.of_miss(within), Verdict::near);
  EXPECT_EQ(judge.of_occluded(within, false), Verdict::near);
  EXPECT_EQ(judge.of_miss(beyond), Verdict::right);
  EXPECT_EQ(judge.of(beyond, 0, 10), Verdict::near);
  EXPECT_EQ(judge.of_occluded(beyond, true), Verdict::near);
  EXPECT_EQ(judge.of(beyond, 1, 10), Verdict::false_hit);
}

TEST(Verdicts, WhatPassesABorderMustMeetWhatIsBehind) {
  const Judge judge(two_quads());
  const Ray on = down(5, 1);
  EXPECT_EQ(judge.of(on, 2, 11), Verdict::boundary);
  EXPECT_EQ(judge.of_miss(on), Verdict::boundary);  // both have their border here
  Mesh mesh = quad(0);
  mesh.push_back(test::triangle({-50, -50, -1}, {50, -50, -1}, {0, 50, -1}));
  const Judge floor(mesh);
  EXPECT_EQ(floor.of(on, 2, 11), Verdict::boundary);
  EXPECT_EQ(floor.of_miss(on), Verdict::false_miss);
}

TEST(Verdicts, Ties) {
  Mesh mesh = quad(0);
  test::append(mesh, quad(0));
  test::append(mesh, quad(-0x1p-20f));  // one ulp of t behind
  test::append(mesh, quad(-0x1p-18f));  // four, but less than the near radius
  const Judge judge(mesh);
  const Ray ray = down(3, 1);
  EXPECT_EQ(judge.of(ray, 0, 10), Verdict::right);
  EXPECT_EQ(judge.of(ray, 2, 10), Verdict::tie);
  EXPECT_EQ(judge.of(ray, 4, 10), Verdict::tie);
  EXPECT_EQ(judge.of(ray, 6, 10), Verdict::near);
  EXPECT_EQ(judge.of_miss(ray), Verdict::false_miss);
  const Judge pair({quad(0)[0], quad(0)[0]});
  EXPECT_EQ(pair.oracle().closest(ray).ray_class, RayClass::tie);
}

TEST(Verdicts, EndsOfTheInterval) {
  const Judge judge(quad(0));
  EXPECT_EQ(judge.of(down(3, 1, 10.0f), 0, 10), Verdict::right);  // closed
  EXPECT_EQ(judge.of_miss(down(3, 1, 10.0f)), Verdict::near);
  const Ray shorter = down(3, 1, std::nextafter(10.0f, 0.0f));
  EXPECT_EQ(judge.of_miss(shorter), Verdict::right);
  EXPECT_EQ(judge.of(shorter, 0, 10), Verdict::near);
  EXPECT_EQ(judge.of(down(3, 1, 9.9f), 0, 10), Verdict::false_hit);
  EXPECT_EQ(judge.of_miss(down(3, 1, 9.9f)), Verdict::right);
  EXPECT_EQ(judge.of_occluded(down(3, 1, 9.9f), true), Verdict::false_hit);
  Ray late = down(3, 1);
  late.tmin = 10.0f;
  EXPECT_EQ(judge.of(late, 0, 10), Verdict::right);
  late.tmin = 10.1f;
  EXPECT_EQ(judge.of(late, 0, 10), Verdict::false_hit);
  EXPECT_EQ(judge.of({{3, 1, -10}, 0, {0, 0, -1}, 100}, 0, -10), Verdict::false_hit);  // behind the origin
}

TEST(Verdicts, AClosedSphereIsSealedButAtItsSilhouette) {
  const Mesh mesh = test::icosphere(3, 2.0f);
  const Judge judge(mesh);
  int leaks = 0;
  for (const Ray& ray : test::vertex_rays(1, 200, mesh, 0.5f)) {  // origins inside
    const Answer answer = judge.oracle().closest(ray);
    ASSERT_TRUE(answer.is_hit());
    leaks += judge.of_miss(ray) == Verdict::leak;
  }
  EXPECT_EQ(leaks, 200);
  // The octahedron's outline from above is |x| + |y| = 1; z = 0 there, and its top vertex is sealed.
  Mesh octahedron;
  for (const float x : {-1.0f, 1.0f}) {
    for (const float y : {-1.0f, 1.0f}) {
      for (const float z : {-1.0f, 1.0f}) octahedron.push_back(test::triangle({x, 0, 0}, {0, y, 0}, {0, 0, z}));
    }
  }
  const Judge eight(octahedron);
  EXPECT_EQ(eight.of_miss(down(0.5f, 0.5f)), Verdict::boundary);
  EXPECT_EQ(eight.of_miss(down(0.4999995f, 0.5f)), Verdict::near);
  EXPECT_EQ(eight.of_miss(down(1, 0)), Verdict::boundary);
  EXPECT_EQ(eight.of_miss(down(0, 0)), Verdict::leak);
  EXPECT_EQ(eight.of_miss(down(0, 0.25f)), Verdict::leak);
  EXPECT_EQ(eight.of_miss(down(0.25f, 0.25f)), Verdict::false_miss);
}

TEST(Verdicts, AMissingTriangleOpensTheFan) {
  const auto fan = [](bool closed) {
    const Vec3 hub{0, 0, 0}, rim[5] = {{2, 0, 0}, {1, 2, 0}, {-2, 1, 0}, {-1, -2, 0}, {1, -1, 0}};
    Mesh mesh;
    for (u32 i = 0; i < (closed ? 5u : 4u); ++i) mesh.push_back(test::triangle(hub, rim[i], rim[(i + 1) % 5]));
    return mesh;
  };
  EXPECT_EQ(Judge(fan(true)).of_miss(down(0, 0)), Verdict::leak);
  EXPECT_EQ(Judge(fan(true)).of_miss(down(1, 0)), Verdict::leak);
  EXPECT_EQ(Judge(fan(false)).of_miss(down(0, 0)), Verdict::boundary);
  EXPECT_EQ(Judge(fan(false)).of_miss(down(1, 0)), Verdict::boundary);
  EXPECT_EQ(Judge(fan(false)).of_miss(down(0.5f, 1)), Verdict::leak);
}

TEST(Verdicts, DegenerateTrianglesSealNothing) {
  Mesh mesh = quad(0);
  mesh.push_back(test::triangle({5, 5, 0}, {5, 5, 1}, {5, 5, -1}));  // along the ray
  mesh.push_back(test::triangle({5, 5, 0}, {5, 5, 0}, {5, 5, 0}));
  mesh.push_back(test::triangle({5, 5, 0}, {5, 5, 0}, {9, 9, 0}));
  const Judge judge(mesh);
  EXPECT_EQ(judge.of_miss(down(5, 5)), Verdict::boundary);
  EXPECT_EQ(judge.of(down(5, 5), 2, 10), Verdict::wrong_id);
  EXPECT_EQ(judge.of(down(6, 6), 4, 10), Verdict::false_hit);
}

TEST(Verdicts, ARiserSeenFromAboveJoinsTwoSteps) {
  // Steps at z = 1 (x < 0) and z = 0 (x > 0), and the vertical riser between them.
  const Mesh mesh = {
      test::triangle({-2, -2, 1}, {0, -2, 1}, {0, 2, 1}), test::triangle({0, -2, 1}, {0, -2, 0}, {0, 2, 0}),
      test::triangle({0, -2, 1}, {0, 2, 0}, {0, 2, 1}), test::triangle({0, -2, 0}, {2, 0, 0}, {0, 2, 0})};
  const Judge judge(mesh);
  EXPECT_EQ(judge.oracle().closest(down(0, 0.5f)).hit.id, 0u);
  EXPECT_EQ(judge.of(down(0, 0.5f), 3, 10), Verdict::boundary);  // a ray a little to the right meets it
  EXPECT_EQ(judge.of_miss(down(0, 0.5f)), Verdict::leak);
}

TEST(Verdicts, ATJunctionThatMeetsExactlyIsNoHole) {
  // The right side has one more vertex, exactly on the shared edge; it is joined by its ends alone.
  const Mesh mesh = {test::triangle({0, -1, 0}, {0, 1, 0}, {-1, 0, 0}),
                     test::triangle({0, -1, 0}, {1, 0, 0}, {0, 0, 0}), test::triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})};
  const Judge judge(mesh);
  EXPECT_EQ(judge.of(down(0, 0.5f), 2, 10), Verdict::boundary);
  EXPECT_EQ(judge.oracle().closest(down(0, 0)).ties.size(), 3u);
  EXPECT_TRUE(is_acceptable(judge.of_miss(down(0, 0.5f))));
}

/// The closest hit of all triangles by one of the kernels' tests.
template <class Intersector>
Hit hit_by(const Ray& ray, const Mesh& mesh) {
  const Intersector prepared(ray);
  Hit best = miss_of(ray);
  for (u32 id = 0; id < mesh.size(); ++id) {
    float t, u, v;
    if (intersect(prepared, mesh[id], t, u, v) && t >= ray.tmin && closer(t, id, best)) best = {t, id, u, v};
  }
  return best;
}

TEST(Verdicts, TellAWatertightTestFromALeakyOne) {
  const Mesh mesh = test::icosphere(2, 2.0f);
  const Judge judge(mesh);
  Figures watertight, leaky;
  std::vector<Ray> rays = test::edge_rays(1, 1000, mesh, 0.2f);
  for (const Ray& ray : test::vertex_rays(2, 1000, mesh)) rays.push_back(ray);
  for (const Ray& ray : rays) {
    watertight.add(judge.oracle().judge(ray, hit_by<Watertight>(ray, mesh)));
    leaky.add(judge.oracle().judge(ray, hit_by<MoellerTrumbore>(ray, mesh)));
  }
  EXPECT_EQ(watertight.wrong(), 0u);
  EXPECT_EQ(watertight.rays(), 2000u);
  EXPECT_GT(leaky.count(Verdict::leak), 100u);
  EXPECT_EQ(leaky.wrong(), leaky.count(Verdict::leak));
  EXPECT_LE(watertight.well_conditioned_t_ulps.percentile(0.5), 2.0);
}

}  // namespace
}  // namespace raywalk::oracle
