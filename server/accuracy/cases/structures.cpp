// Scenes that are hard for spatial structures: their work, their memory, their depth.
#include <algorithm>
#include <cmath>

#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {
namespace {

u64 steps_of(Exam& exam, const StructureRef& structure, const std::vector<Ray>& rays) {
  u64 steps = 0;
  for (const Counts& counts : exam.count_work(structure, rays)) steps += counts.steps;
  exam.add_rays(rays.size());
  return steps;
}

/// A structure may take this much, whatever the scene looks like.
void takes_bounded_memory(Exam& exam, const std::string& name, const StructureRef& structure, u64 triangles) {
  const u64 bytes = structure->stats().size_bytes, limit = 4096 * triangles + (u64{64} << 20);
  if (bytes > limit) exam.fail(name + ": " + std::to_string(bytes) + " bytes, more than " + std::to_string(limit));
}

Mesh stretched_soup(u32 triangles, Vec3 by) {
  Mesh mesh = random_soup(1, triangles, 0.1f);
  for (Corners& t : mesh)
    for (Vec3* p : {&t.a, &t.b, &t.c}) *p = *p * by;
  return mesh;
}

/// From around a mesh at points inside random triangles.
std::vector<Ray> rays_at(const Mesh& mesh, u32 count, float reach, Random random) {
  const Box bounds = bounds_of(mesh);
  std::vector<Ray> rays;
  for (u32 i = 0; i < count; ++i) {
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const float u = random.uniform(0.1f, 0.4f), v = random.uniform(0.1f, 0.4f);
    const Vec3 half = bounds.extent() * (0.5f * reach);
    rays.push_back(ray_towards(random.in_box(bounds.centre() - half, bounds.centre() + half),
                               t.a * (1.0f - u - v) + t.b * u + t.c * v));
  }
  return rays;
}

/// In the cube [-1, 1]^3 triangles smaller than the cells of a long walk, close to where such a walk changes its row of
/// cells; and for each a ray from outside that is aimed at it. A walk that is a cell off passes some of them.
Mesh specks_at_borders(Random& random, u32 count, std::vector<Ray>& rays) {
  Mesh mesh = {triangle({-1, -1, -1}, {-1, -0.9f, -1}, {-0.9f, -1, -1}),
               triangle({1, 1, 1}, {1, 0.9f, 1}, {0.9f, 1, 1})};
  for (u32 i = 0; i < count; ++i) {
    const u32 main = i % 3;
    const auto along_axes = [&](float a, float b, float c) {
      return main == 0 ? Vec3{a, b, c} : main == 1 ? Vec3{c, a, b} : Vec3{b, c, a};
    };
    const float border = 0.25f * (static_cast<float>(random.below(7)) - 3.0f);
    const Vec3 centre =
        along_axes(random.uniform(-0.9f, 0.9f), border + random.uniform(-1e-4f, 1e-4f), random.uniform(-0.9f, 0.9f));
    const Vec3 half{1e-5f, 1e-5f, 1e-5f};
    const Vec3 p = random.in_box(-half, half), q = random.in_box(-half, half);
    mesh.push_back(triangle(centre + p, centre + q, centre - p - q));
    const float forward = random.uniform(0.7f, 1.0f) * (random.below(2) != 0 ? 1.0f : -1.0f);
    const Vec3 way = along_axes(forward, random.uniform(-0.6f, 0.6f), random.uniform(-0.3f, 0.3f));
    rays.push_back(ray_towards(centre - way * 2.2f, centre));
  }
  return mesh;
}

}  // namespace

void vertical_rays(Exam& exam) {
  const u32 n = std::min(500u, static_cast<u32>(std::sqrt(static_cast<double>(exam.count(250'000, 1600)))));
  const SceneBlob& scene = exam.store().get("box", [&] { return scene_of(subdivided_box(n)); });
  const StructureRef structure = exam.build(scene);
  Random random = exam.random(1);
  std::vector<Ray> vertical, jittered;
  for (u32 i = 0; i < exam.count(50'000, 1000); ++i) {
    const auto at = [&] {
      if (random.below(2) != 0) return random.uniform(-0.99f, 0.99f);
      return -1.0f + 2.0f * (static_cast<float>(1 + random.below(n - 1)) / static_cast<float>(n));
    };
    const Ray ray{{at(), at(), 2.0f}, 0.0f, {0.0f, random.below(2) != 0 ? 0.0f : -0.0f, -1.0f}, kFarAway};
    vertical.push_back(ray);
    jittered.push_back(ray);
    jittered.back().d = jittered.back().d + random.in_box({-1e-3f, -1e-3f, 0}, {1e-3f, 1e-3f, 0});
  }
  const u64 steps = steps_of(exam, structure, vertical), usual = steps_of(exam, structure, jittered);
  if (steps > 2 * usual)
    exam.fail(std::to_string(steps) + " steps of vertical rays, " + std::to_string(usual) + " of jittered ones");
  std::vector<Ray> some(vertical.begin(), vertical.begin() + std::min<std::ptrdiff_t>(2000, std::ssize(vertical)));
  meets(exam, scene, some, 2);
}

void many_cells(Exam& exam) {
  const Trial& trial = *exam.store().get("trial", [&] {
    Random random = exam.random(1);
    std::vector<Ray> rays;
    const Mesh mesh = specks_at_borders(random, exam.count(2'000), rays);
    return make_trial("long walks", mesh, rays);
  });
  if (exam.build_option("resolution_x") == nullptr) return judge_and_compare(exam, trial);
  const double resolutions[][3] = {{16384, 8, 8}, {8, 16384, 8}, {16, 16, 4096}};
  for (const auto& r : resolutions)
    judge_and_compare(exam, trial, {{"resolution_x", r[0]}, {"resolution_y", r[1]}, {"resolution_z", r[2]}});
}

void steps_of_a_walk(Exam& exam) {
  const Mesh& mesh =
      exam.store().get("mesh", [&] { return transformed(random_soup(exam.seed(1), 1500, 0.05f), 800.0f, {}); });
  const SceneBlob& scene = exam.store().get("scene", [&] { return scene_of(mesh); });
  const StructureRef structure =
      exam.build(scene, {{"resolution_x", 100}, {"resolution_y", 100}, {"resolution_z", 100}});
  std::vector<Ray> rays = random_rays(exam.seed(2), exam.count(10'000), bounds_of(mesh));
  rays.push_back(ray_towards({-668, -340, 77}, {404, -64, -784}));
  const BuildStats& stats = structure->stats();
  const u32* cells = stats.resolution;
  // A restart of a short stack walks down once more for each leaf, so its steps have no such bound; only that there is
  // one tells that the walk ends.
  const u64 limit = cells[0] != 0 ? u64{cells[0]} + cells[1] + cells[2] : stats.nodes * (stats.max_depth + 1u);
  const std::vector<Counts> counts = exam.count_work(structure, rays);
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (counts[i].steps <= limit) continue;
    exam.fail([&] {
      return Failure{std::to_string(counts[i].steps) + " steps, more than " + std::to_string(limit), rays[i]};
    });
  }
}

void stretched_scenes(Exam& exam) {
  for (const Vec3 by : {Vec3{1, 1, 1e6f}, Vec3{1e6f, 1, 1}, Vec3{1, 1e6f, 1e3f}}) {
    const Trial& trial = *exam.store().get("stretched by " + text_of(by.x) + text_of(by.y), [&] {
      const Mesh mesh = stretched_soup(1000, by);
      return make_trial("stretched", mesh, rays_at(mesh, exam.count(300), 2.0f, exam.random(1)));
    });
    takes_bounded_memory(exam, trial.name, exam.build(trial.scene), trial.mesh.size());
    judge_and_compare(exam, trial);
  }
  const Trial& stadium = *exam.store().get("stadium", [&] {
    const Mesh teapot = transformed(icosphere(3), 1.0f, {3, 4, 5});
    Mesh mesh = teapot;
    append(mesh, subdivided_box(20, -1e6f, 1e6f));
    return make_trial("a teapot in a stadium", mesh, rays_at(teapot, exam.count(300), 3.0f, exam.random(2)));
  });
  takes_bounded_memory(exam, stadium.name, exam.build(stadium.scene), stadium.mesh.size());
  judge_and_compare(exam, stadium);
}

void node_formats(Exam& exam) {
  const Option* nodes = exam.build_option("nodes");
  if (nodes == nullptr) return exam.does_not_apply("its nodes have one format");
  const std::pair<const char*, Mesh> scenes[] = {{"sphere", icosphere(4, 2.0f)},
                                                 {"far sphere", transformed(icosphere(3), 1.0f, {1e4f, -1e4f, 5e3f})},
                                                 {"stretched", stretched_soup(5000, {1, 1, 1e6f})},
                                                 {"box", subdivided_box(16)}};
  for (const auto& [name, mesh] : scenes) {
    const Trial& trial = *exam.store().get(name, [&, &shape = mesh] {
      std::vector<Ray> rays = rays_at(shape, exam.count(5'000), 3.0f, exam.random(1));
      const u32 count = exam.count(2'000);
      for (const auto& more : {edge_rays(exam.seed(2), count, shape), vertex_rays(exam.seed(3), count, shape),
                               axis_rays(exam.seed(4), count, shape)})
        rays.insert(rays.end(), more.begin(), more.end());
      return make_trial(name, shape, rays);
    });
    for (std::size_t i = 0; i < nodes->choices.size(); ++i)
      judge_and_compare(exam, trial, {{"nodes", static_cast<double>(i)}});
  }
}

void identical_triangles(Exam& exam) {
  const u32 copies = std::min(exam.count(100'000, 2000), 100'000u);
  const Corners one = triangle({0.1f, 0.2f, 0.3f}, {1.3f, 0.1f, 0.2f}, {0.4f, 1.1f, -0.3f});
  const SceneBlob& scene = exam.store().get("scene", [&] { return scene_of(Mesh(copies, one)); });
  const StructureRef structure = exam.build(scene);
  takes_bounded_memory(exam, "identical triangles", structure, copies);
  Random random = exam.random(1);
  std::vector<Ray> rays;
  for (u32 i = 0; i < 200; ++i) {
    const float u = random.uniform(0.1f, 0.4f), v = random.uniform(0.1f, 0.4f);
    rays.push_back(ray_towards(random.in_box({0, 0, 1}, {1, 1, 3}), one.a * (1.0f - u - v) + one.b * u + one.c * v));
  }
  const std::vector<Hit> hits = exam.closest(structure, rays);
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (hits[i].id != 0) exam.fail([&] { return Failure{"given " + text_of(hits[i]), rays[i], {one}}; });
}

void shrinking_triangles(Exam& exam) {
  constexpr u32 kSmallest = 120, kSmallestJudged = 55;  // smaller ones have a squared extent that is no float
  Mesh mesh;
  std::vector<Ray> judged, others;
  Random random = exam.random(1);
  for (u32 k = 0; k <= kSmallest; ++k) {
    const float s = std::ldexp(1.0f, -static_cast<int>(k));
    mesh.push_back(triangle(Vec3{1, 0, 0} * s, Vec3{2, 0, 0.25f} * s, Vec3{1, 1, 0.5f} * s));
    for (u32 i = 0; i < exam.count(1'000, 16); ++i) {
      const Vec3 target = Vec3{1.0f + random.uniform(0.1f, 0.4f), random.uniform(0.1f, 0.4f), 0.0f} * s;
      const Vec3 from = random.in_box({0.9f, -0.2f, 1}, {1.3f, 0.2f, 3}) * s;
      (k <= kSmallestJudged ? judged : others).push_back(ray_towards(from, target));
    }
  }
  const Trial& trial = *exam.store().get("trial", [&] { return make_trial("sizes 2^-k", mesh, judged); });
  takes_bounded_memory(exam, trial.name, exam.build(trial.scene), mesh.size());
  judge_and_compare(exam, trial);
  exam.closest(exam.build(trial.scene), others);
  exam.add_rays(others.size());
}

}  // namespace raywalk::accuracy
