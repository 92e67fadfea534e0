// The oracle of a scene against all of its triangles, one after the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "server/accuracy/oracle/scene_oracle.h"
#include "tests/support/meshes.h"

namespace raywalk::oracle {
namespace {

using test::Mesh;

struct Expected {
  Answer answer;
  Occlusion occlusion;
};

/// Every triangle, no tree. `answer` follows the contract of Answer, in other words than the oracle's.
Expected brute(const Ray& ray, const Mesh& mesh) {
  struct Found {
    u32 id;
    Crossing crossing;
    bool counts, strict, boundary;
  };
  std::vector<Found> all;
  for (u32 id = 0; id < mesh.size(); ++id) {
    const Crossing c = classify(ray, mesh[id]);
    if (!c.touched() || c.high < ray.tmin || c.low > ray.tmax) continue;
    const bool counts =
        c.met() && compare_distance(ray, mesh[id], ray.tmin) >= 0 && compare_distance(ray, mesh[id], ray.tmax) <= 0;
    const bool strict = counts && c.position == Position::inside && !c.near && c.low >= ray.tmin && c.high <= ray.tmax;
    all.push_back({id, c, counts, strict, c.position >= Position::edge});
  }
  Expected result;
  result.answer.hit = miss_of(ray);
  const Found* first = nullptr;
  for (const Found& f : all) {
    if (f.counts && (!first || f.crossing.t < first->crossing.t)) first = &f;
    if (f.counts) result.occlusion.occluded = true;
  }
  const auto raise = [](RayClass& c, RayClass to) { c = std::max(c, to); };
  RayClass& ray_class = result.answer.ray_class;
  bool any_strict = false;
  for (const Found& f : all) {
    any_strict = any_strict || f.strict;
    raise(result.occlusion.ray_class, f.boundary ? RayClass::boundary : RayClass::near);
    if (first && f.crossing.low > first->crossing.high) continue;
    if (f.boundary) raise(ray_class, RayClass::boundary);
    if (!f.strict) raise(ray_class, RayClass::near);
    if (!first) continue;
    const bool tie =
        std::abs(f.crossing.precise_t - first->crossing.precise_t) <= 2 * ulp_at(first->crossing.precise_t);
    if (f.counts && tie) result.answer.ties.push_back({f.id, f.crossing.position});
    if (&f != first && f.strict) raise(ray_class, tie ? RayClass::tie : RayClass::near);
  }
  if (any_strict) result.occlusion.ray_class = RayClass::strict;
  if (first) result.answer.hit = {first->crossing.t, first->id, 0, 0};
  return result;
}

int hits_of(const Mesh& mesh, const std::vector<Ray>& rays) {
  const Blob scene = test::make_scene(mesh);
  const SceneOracle oracle(test::view_of(scene));
  int hits = 0, wrong = 0;
  for (const Ray& ray : rays) {
    const Expected expected = brute(ray, mesh);
    const Answer answer = oracle.closest(ray);
    const Occlusion occlusion = oracle.occluded(ray);
    hits += answer.is_hit();
    const bool same_ties = std::equal(
        answer.ties.begin(), answer.ties.end(), expected.answer.ties.begin(), expected.answer.ties.end(),
        [](const IdAtPosition& a, const IdAtPosition& b) { return a.id == b.id && a.position == b.position; });
    const bool same = answer.hit.id == expected.answer.hit.id && answer.hit.t == expected.answer.hit.t && same_ties &&
                      answer.ray_class == expected.answer.ray_class &&
                      occlusion.occluded == expected.occlusion.occluded &&
                      occlusion.ray_class == expected.occlusion.ray_class;
    // Its own answers are right.
    const Judgement judgement = oracle.judge(ray, answer.hit);
    const bool right = judgement.verdict == Verdict::right && judgement.ray_class == answer.ray_class &&
                       judgement.t_ulps.has_value() == answer.is_hit() && judgement.t_ulps.value_or(0) <= 0.501 &&
                       oracle.judge_occluded(ray, occlusion.occluded).verdict == Verdict::right;
    if ((same && right) || ++wrong > 3) continue;
    ADD_FAILURE() << "id " << answer.hit.id << ", not " << expected.answer.hit.id << "; class "
                  << name_of(answer.ray_class) << ", not " << name_of(expected.answer.ray_class) << "; ties "
                  << answer.ties.size() << ", not " << expected.answer.ties.size() << "; occlusion "
                  << name_of(occlusion.ray_class) << ", not " << name_of(expected.occlusion.ray_class) << "; judged "
                  << name_of(judgement.verdict);
  }
  return hits;
}

/// Random, edge-aimed, vertex-aimed and axis-parallel ones, some with a short interval.
std::vector<Ray> rays_at(const Mesh& mesh, u32 count) {
  std::vector<Ray> rays = test::random_rays(1, count, test::bounds_of(mesh));
  const auto more = [&rays](const std::vector<Ray>& other) { rays.insert(rays.end(), other.begin(), other.end()); };
  more(test::edge_rays(2, count, mesh));
  more(test::vertex_rays(3, count, mesh));
  more(test::axis_rays(4, count, mesh));
  for (u32 i = 0; i < rays.size(); i += 7) rays[i].tmin = rays[i].tmax = 1.0f;
  for (u32 i = 3; i < rays.size(); i += 7) rays[i].tmax = 1.0f;
  for (u32 i = 5; i < rays.size(); i += 7) rays[i].tmin = 1.0f;
  return rays;
}

TEST(SceneOracle, ClosedSphere) {
  const Mesh mesh = test::icosphere(3, 2.0f);
  EXPECT_GT(hits_of(mesh, rays_at(mesh, 100)), 200);
}

TEST(SceneOracle, SoupAndSlivers) {
  Mesh mesh = test::random_soup(1, 800, 0.5f);
  test::append(mesh, test::slivers(2, 200));
  EXPECT_GT(hits_of(mesh, rays_at(mesh, 100)), 200);
}

TEST(SceneOracle, Lattice) {
  const Mesh mesh = test::integer_lattice(3, 600, 4);
  EXPECT_GT(hits_of(mesh, rays_at(mesh, 60)), 100);
}

TEST(SceneOracle, FlatFacesAndDuplicates) {
  Mesh mesh = test::subdivided_box(6);
  test::append(mesh, test::subdivided_box(6));
  EXPECT_GT(hits_of(mesh, rays_at(mesh, 80)), 100);
}

TEST(SceneOracle, OffsetsAndScales) {
  for (const Vec3 offset : {Vec3{1e6f, -1e6f, 1e6f}, Vec3{0, 1e4f, 0}}) {
    const Mesh mesh = test::icosphere(2, 3.0f, offset);
    EXPECT_GT(hits_of(mesh, rays_at(mesh, 60)), 100);
  }
  for (const float scale : {1e-30f, 1e-6f, 1e17f}) {
    const Mesh mesh = test::transformed(test::icosphere(2), scale, {0, 0, 0});
    std::vector<Ray> rays = rays_at(test::icosphere(2), 60);
    for (Ray& ray : rays) ray.o = ray.o * scale, ray.d = ray.d * scale;
    EXPECT_GT(hits_of(mesh, rays), 100);
  }
}

TEST(SceneOracle, ManyEqualTriangles) {
  const Mesh mesh(1000, test::triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}));
  const Blob scene = test::make_scene(mesh);
  const Answer answer = SceneOracle(test::view_of(scene)).closest(test::ray_towards({0, 0, 1}, {0.1f, 0, 0}));
  EXPECT_EQ(answer.hit.id, 0u);
  EXPECT_EQ(answer.ties.size(), 1000u);
  EXPECT_EQ(answer.ray_class, RayClass::tie);
}

TEST(SceneOracle, EmptyScenesAndInvalidRays) {
  const Ray ray{{0, 0, 1}, 0, {0, 0, -1}, 10};
  const Blob empty = test::make_scene({});
  EXPECT_FALSE(SceneOracle(test::view_of(empty)).closest(ray).is_hit());
  EXPECT_EQ(SceneOracle(test::view_of(empty)).closest(ray).hit.t, 10.0f);

  constexpr float kInf = std::numeric_limits<float>::infinity();
  const Corners good = test::triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const Blob scene = test::make_scene({test::triangle({0, 0, kInf}, {1, 0, 0}, {0, 1, 0}), good});
  const SceneOracle oracle(test::view_of(scene));
  EXPECT_EQ(oracle.closest(ray).hit.id, 1u);
  EXPECT_TRUE(oracle.occluded(ray).occluded);
  for (const Ray& bad : {Ray{ray.o, 0, {0, 0, 0}, 10}, Ray{ray.o, 0, {0, 0, -kInf}, 10}, Ray{ray.o, 0, ray.d, kInf}}) {
    EXPECT_FALSE(oracle.closest(bad).is_hit());
    EXPECT_FALSE(oracle.occluded(bad).occluded);
    EXPECT_EQ(oracle.judge(bad, {0, 1, 0, 0}).verdict, Verdict::false_hit);
    EXPECT_EQ(oracle.judge(bad, miss_of(bad)).verdict, Verdict::right);
    EXPECT_EQ(oracle.judge_occluded(bad, true).verdict, Verdict::false_hit);
  }
}

}  // namespace
}  // namespace raywalk::oracle
