// Scenes and rays that are hard for spatial structures, and the comparison with the linear loop.
#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "kernels/accel/brute/traverse.h"
#include "kernels/accel/kind.h"
#include "kernels/counter.h"
#include "tests/support/meshes.h"

namespace raywalk::test {

struct SpatialCase {
  std::string name;
  Mesh mesh;
  std::vector<Ray> rays;
};

/// The options' defaults, with some replaced.
inline OptionValues options_of(const Kind& kind, const OptionValues& given = {}) {
  OptionValues options = given;
  for (const Option& option : kind.options) options.emplace(option.name, option.default_value);
  return options;
}

/// What brute force says of a ray.
struct Answer {
  Hit closest;
  bool occluded;
};

inline std::vector<Answer> brute_force(SceneView scene, const std::vector<Ray>& rays) {
  std::vector<Answer> answers;
  NoCounter counter;
  for (const Ray& ray : rays) {
    ClosestHit closest(ray);
    AnyHit any(ray);
    if (is_valid(ray)) {
      brute::traverse(nullptr, scene, ray, closest, counter);
      brute::traverse(nullptr, scene, ray, any, counter);
    }
    answers.push_back({closest.best, any.occluded});
  }
  return answers;
}

/// Compares the closest hit (t bit for bit, id, u, v) and the occlusion of each valid ray with brute force. `trace` is
/// a traversal as a function object (blob, scene, ray, query, counter).
template <class Trace>
void expect_answers(const std::vector<Answer>& answers, SceneView scene, const u8* blob, const std::vector<Ray>& rays,
                    const Trace& trace, const std::string& what) {
  u32 wrong = 0;
  NoCounter counter;
  for (size_t i = 0; i < rays.size() && wrong < 3; ++i) {
    const Ray& ray = rays[i];
    if (!is_valid(ray)) continue;
    ClosestHit closest(ray);
    AnyHit any(ray);
    trace(blob, scene, ray, closest, counter);
    trace(blob, scene, ray, any, counter);
    const Hit &a = answers[i].closest, &b = closest.best;
    const bool same = a.id == b.id && bits_of(a.t) == bits_of(b.t) && bits_of(a.u) == bits_of(b.u) &&
                      bits_of(a.v) == bits_of(b.v) && answers[i].occluded == any.occluded;
    if (same) continue;
    ++wrong;
    ADD_FAILURE() << what << ", ray " << i << ": o " << ray.o.x << " " << ray.o.y << " " << ray.o.z << " d " << ray.d.x
                  << " " << ray.d.y << " " << ray.d.z << " [" << ray.tmin << ", " << ray.tmax << "]: expected id "
                  << a.id << " t " << a.t << ", got id " << b.id << " t " << b.t << "; occluded " << answers[i].occluded
                  << ", got " << any.occluded;
  }
}

template <class Trace>
void expect_same_as_brute(SceneView scene, const u8* blob, const std::vector<Ray>& rays, const Trace& trace,
                          const std::string& what) {
  expect_answers(brute_force(scene, rays), scene, blob, rays, trace, what);
}

inline std::vector<Ray> mixed_rays(u32 seed, u32 count, const Mesh& mesh) {
  std::vector<Ray> rays = random_rays(seed, count, bounds_of(mesh));
  for (const auto& more :
       {edge_rays(seed + 1, count, mesh), vertex_rays(seed + 2, count, mesh), axis_rays(seed + 3, count, mesh)}) {
    rays.insert(rays.end(), more.begin(), more.end());
  }
  return rays;
}

/// Origins `away` half extents from the centre (in any direction), aimed at points, edges and vertices of the mesh.
inline std::vector<Ray> far_rays(u32 seed, u32 count, const Mesh& mesh, float away) {
  Random random(seed);
  const Box bounds = bounds_of(mesh);
  const float reach = away * 0.5f * largest(bounds.extent());
  std::vector<Ray> rays;
  for (u32 i = 0; i < count; ++i) {
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const float s = random.below(3) == 0 ? 1.0f : random.uniform();
    Vec3 side = random.direction();
    if (random.below(4) == 0) side = {side.x > 0 ? 1.0f : -1.0f, random.below(2) ? 0.0f : -0.0f, 0.0f};
    const Vec3 target = t.a * s + t.b * (1 - s);
    rays.push_back(ray_towards(target + side * reach, target));
    if (random.below(2) != 0) rays.back().d = rays.back().d * 1e-3f;
  }
  return rays;
}

/// Lattice origins with directions in {-3..3}^3 over [0, size]^3.
inline std::vector<Ray> lattice_rays(u32 seed, u32 count, u32 size) {
  Random random(seed);
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const auto at = [&] { return static_cast<float>(random.below(2 * size + 1)) * 0.5f; };
    const auto way = [&] {
      const float d = static_cast<float>(random.below(7)) - 3.0f;
      return d == 0.0f && random.below(2) != 0 ? -0.0f : d;
    };
    const Ray ray{{at(), at(), at()}, 0.0f, {way(), way(), way()}, kFarAway};
    if (is_valid(ray)) rays.push_back(ray);
  }
  return rays;
}

/// The rays with the interval cut to random ends, some exactly at a hit or one step beside it.
inline std::vector<Ray> with_limits(u32 seed, std::vector<Ray> rays, SceneView scene) {
  Random random(seed);
  NoCounter counter;
  for (Ray& ray : rays) {
    ClosestHit query(ray);
    brute::traverse(nullptr, scene, ray, query, counter);
    const float t = query.best.id == kMiss ? random.uniform(0.0f, 3.0f) : query.best.t;
    const float ends[4] = {t, std::nextafter(t, -kMaxFloat), std::nextafter(t, kMaxFloat), t * random.uniform(0, 2)};
    (random.below(2) != 0 ? ray.tmin : ray.tmax) = ends[random.below(4)];
    if (random.below(8) == 0) ray.tmin = -t;
    if (random.below(16) == 0) ray.tmin = -kMaxFloat;
  }
  return rays;
}

inline Mesh repeated(const Mesh& mesh, u32 times) {
  Mesh all;
  for (u32 i = 0; i < times; ++i) append(all, mesh);
  return all;
}

inline Mesh stretched(Mesh mesh, Vec3 by) {
  for (Corners& t : mesh) {
    t.a = t.a * by;
    t.b = t.b * by;
    t.c = t.c * by;
  }
  return mesh;
}

/// A soup in which some vertices are NaN or infinite and some triangles are points and lines.
inline Mesh broken_soup() {
  Mesh mesh = random_soup(71, 300, 0.5f);
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (u32 i = 0; i < mesh.size(); i += 7) mesh[i].b.y = nan;
  for (u32 i = 1; i < mesh.size(); i += 7) mesh[i].c.x = i % 2 ? infinity : -infinity;
  for (u32 i = 2; i < mesh.size(); i += 7) mesh[i].c = mesh[i].b;
  for (u32 i = 3; i < mesh.size(); i += 7) mesh[i].b = mesh[i].c = mesh[i].a;
  for (u32 i = 4; i < mesh.size(); i += 7) mesh[i].c = 0.5f * mesh[i].a + 0.5f * mesh[i].b;
  return mesh;
}

/// All scenes; each is small enough for brute force.
inline std::vector<SpatialCase> spatial_cases() {
  std::vector<SpatialCase> cases;
  const auto add = [&](std::string name, Mesh mesh, std::vector<Ray> rays) {
    cases.push_back({std::move(name), std::move(mesh), std::move(rays)});
  };
  const auto add_mixed = [&](std::string name, const Mesh& mesh, u32 count = 400) {
    add(std::move(name), mesh, mixed_rays(static_cast<u32>(cases.size()) * 10 + 1, count, mesh));
  };
  const Mesh soup = random_soup(1, 1500), sphere = icosphere(3), box = subdivided_box(8);
  add_mixed("soup", soup);
  add_mixed("large triangles", random_soup(2, 300, 2.0f));
  add_mixed("sphere", sphere, 1500);
  add_mixed("box", box, 1500);
  add_mixed("boxes in a box", [&] {
    Mesh mesh = box;
    append(mesh, subdivided_box(4, -0.5f, 0.25f));
    append(mesh, subdivided_box(2, -0.25f, 1.0f));
    return mesh;
  }());
  add_mixed("slivers", slivers(3, 500));
  add_mixed("duplicates", repeated(random_soup(4, 100, 0.5f), 8));
  add_mixed("extents 1:1:1e6", stretched(soup, {1, 1, 1e6f}));
  add_mixed("extents 1e6:1:1e3", stretched(sphere, {1e6f, 1, 1e3f}));
  add_mixed("tiny in huge", [&] {
    Mesh mesh = subdivided_box(2, -1e6f, 1e6f);
    append(mesh, transformed(sphere, 1.0f, {3, 4, 5}));
    return mesh;
  }());
  add(
      "tiny in huge, aimed",
      [&] {
        Mesh mesh = transformed(sphere, 1.0f, {3, 4, 5});
        append(mesh, subdivided_box(2, -1e6f, 1e6f));
        return mesh;
      }(),
      mixed_rays(5, 300, transformed(sphere, 1.0f, {3, 4, 5})));
  for (const float offset : {1e3f, 1e5f, 1e6f}) {
    add_mixed("offset " + std::to_string(offset), transformed(sphere, 1.0f, {offset, -offset, 0.5f * offset}));
  }
  for (const float scale : {1e-6f, 1e-3f, 1e3f, 1e6f}) add_mixed("scale", transformed(sphere, scale, {}));
  add_mixed("flat", quad_grid(8));
  add_mixed("one quad", quad_grid(1));
  add_mixed("one quad far away", transformed(quad_grid(1), 1.0f, {1e6f, 1e6f, 1e6f}));
  add_mixed("one triangle", {soup[0]});
  add_mixed("broken", broken_soup());
  add("points", repeated({triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3})}, 5), random_rays(6, 100, {{0, 0, 0}, {2, 3, 4}}));
  add("empty", {}, random_rays(7, 100, {{0, 0, 0}, {2, 3, 4}}));
  add("all broken", repeated({triangle({1, 2, std::numeric_limits<float>::quiet_NaN()}, {}, {1, 0, 0})}, 5),
      random_rays(8, 100, {{0, 0, 0}, {2, 3, 4}}));
  add("lattice", integer_lattice(9, 600, 8), lattice_rays(10, 3000, 8));
  const Mesh cube = transformed(box, 4.0f, {4, 4, 4});
  add("box on the lattice", cube, lattice_rays(11, 3000, 8));
  add("quads on the lattice", transformed(quad_grid(8), 4.0f, {4, 4, 4}), lattice_rays(12, 2000, 8));
  for (const float away : {3.0f, 7.9f, 8.1f, 30.0f, 1e3f, 1e5f, 1e6f}) {
    const u32 count = away > 2e5f ? 100 : 1000;  // so far away nearly all cells are near the ray
    add("far " + std::to_string(away), sphere, far_rays(13, count, sphere, away));
    add("far from a soup " + std::to_string(away), soup, far_rays(14, count, soup, away));
    const Mesh flat = quad_grid(8);
    add("far from a quad " + std::to_string(away), flat, far_rays(15, count, flat, away));
  }
  std::vector<Ray> scaled = mixed_rays(16, 500, sphere);
  const float scales[] = {1e-38f, 1e-30f, 1e-10f, 1e10f, 1e30f, 1e-41f};
  for (size_t i = 0; i < scaled.size(); ++i) {
    scaled[i].d = scaled[i].d * scales[i % 6];
    scaled[i].tmax = kMaxFloat;
  }
  add("direction lengths", sphere, scaled);
  const Blob scene = make_scene(soup), sphere_scene = make_scene(sphere);
  add("limits", soup, with_limits(17, mixed_rays(18, 400, soup), view_of(scene)));
  add("limits of a sphere", sphere, with_limits(19, mixed_rays(20, 400, sphere), view_of(sphere_scene)));
  add("limits from afar", sphere, with_limits(21, far_rays(22, 800, sphere, 50.0f), view_of(sphere_scene)));
  return cases;
}

}  // namespace raywalk::test
