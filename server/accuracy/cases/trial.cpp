// Compares answers with the oracle, with brute force and with each other.
#include "server/accuracy/cases/trial.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "server/accuracy/cases/hex.h"

namespace raywalk::accuracy {
namespace {

constexpr u32 kShared = 64;  // triangles around a failure that are worth looking at

std::vector<u32> ids_of(const oracle::Answer& answer, const Hit& given) {
  std::vector<u32> ids;
  for (const oracle::IdAtPosition& tie : answer.ties) ids.push_back(tie.id);
  if (answer.is_hit()) ids.push_back(answer.hit.id);
  if (given.id != kMiss) ids.push_back(given.id);
  return ids;
}

/// What the oracle thinks of the technique's answer among these triangles alone.
oracle::Verdict verdict_among(Exam& exam, const Ray& ray, const Mesh& triangles) {
  const SceneBlob scene = scene_of(triangles);
  return oracle::SceneOracle({scene->data()}).judge(ray, exam.closest_among(triangles, {ray}).front()).verdict;
}

Failure wrong_verdict(Exam& exam, const Trial& trial, std::size_t i, const Hit& given, oracle::Verdict verdict) {
  const oracle::Answer& answer = trial.answers[i];
  return {trial.name + ": " + oracle::name_of(verdict) + ", given " + text_of(given) + ", exact " +
              (answer.is_hit() ? text_of(answer.hit) : "miss"),
          trial.rays[i], ring_around(trial.mesh, ids_of(answer, given)),
          [&exam](const Ray& ray, const Mesh& triangles) {
            return !oracle::is_acceptable(verdict_among(exam, ray, triangles));
          }};
}

Ray behind(Ray ray, const Hit& hit) {
  ray.tmin = std::nextafter(hit.t, kMaxFloat);
  return ray;
}

bool share_a_vertex(const Corners& a, const Corners& b) {
  for (const Vec3 p : {a.a, a.b, a.c})
    if (p == b.a || p == b.b || p == b.c) return true;
  return false;
}

/// Among these triangles the technique sees two neighbours at one place, or none where the surface is sealed.
bool meets_wrongly(Exam& exam, const Ray& ray, const Mesh& triangles) {
  const Hit first = exam.closest_among(triangles, {ray}).front();
  if (first.id == kMiss) return !oracle::is_acceptable(verdict_among(exam, ray, triangles));
  const Hit second = exam.closest_among(triangles, {behind(ray, first)}).front();
  if (second.id != kMiss && second.t <= first.t * 1.000001f &&
      share_a_vertex(triangles[first.id], triangles[second.id])) {
    return true;
  }
  const Mesh reversed(triangles.rbegin(), triangles.rend());
  const Hit other = exam.closest_among(reversed, {ray}).front();
  return other.id != kMiss && other.id != triangles.size() - 1 - first.id;
}

Failure wrong_number(Exam& exam, const SceneBlob& scene, const Ray& ray, const Hit& first, const std::string& what) {
  const Mesh mesh = mesh_of(scene);
  const oracle::Answer answer = oracle::SceneOracle({scene->data()}).closest(ray);
  return {what + ", given " + text_of(first) + ", exact " + (answer.is_hit() ? text_of(answer.hit) : "miss"), ray,
          ring_around(mesh, ids_of(answer, first)),
          [&exam](const Ray& simpler, const Mesh& triangles) { return meets_wrongly(exam, simpler, triangles); }};
}

/// Of triangles at the same distance the lowest id is given: with the order reversed, another one would be. Asked of
/// every fourth ray.
void no_hidden_neighbours(Exam& exam, const SceneBlob& scene, const std::vector<Ray>& all,
                          const std::vector<Hit>& all_hits) {
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < all.size(); i += 4) {
    rays.push_back(all[i]);
    hits.push_back(all_hits[i]);
  }
  Mesh mesh = mesh_of(scene);
  std::ranges::reverse(mesh);
  const u32 last = static_cast<u32>(mesh.size()) - 1;
  const SceneBlob reversed = exam.store().get(
      "reversed " + std::to_string(reinterpret_cast<std::uintptr_t>(scene.get())), [&] { return scene_of(mesh); });
  const std::vector<Hit> others = exam.closest(exam.build(reversed), rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].id == kMiss || others[i].id == kMiss || hits[i].id == last - others[i].id) continue;
    exam.fail([&] { return wrong_number(exam, scene, rays[i], hits[i], "two triangles at one distance"); });
  }
}

}  // namespace

bool same_bits(const Hit& a, const Hit& b) {
  return a.id == b.id && bits_of(a.t) == bits_of(b.t) && bits_of(a.u) == bits_of(b.u) && bits_of(a.v) == bits_of(b.v);
}

Mesh mesh_of(const SceneBlob& scene) {
  const SceneView view{scene->data()};
  return Mesh(view.corners(), view.corners() + view.triangle_count());
}

Mesh ring_around(const Mesh& mesh, const std::vector<u32>& ids) {
  Mesh ring;
  for (u32 i = 0; i < mesh.size() && ring.size() < kShared; ++i) {
    const bool wanted = std::ranges::any_of(
        ids, [&](u32 id) { return id < mesh.size() && (id == i || share_a_vertex(mesh[id], mesh[i])); });
    if (!wanted) continue;
    ring.push_back(mesh[i]);
    ring.back().id = i;
  }
  return ring;
}

std::shared_ptr<const Trial> make_trial(std::string name, const Mesh& mesh, std::vector<Ray> rays) {
  auto trial = std::make_shared<Trial>();
  trial->name = std::move(name);
  trial->mesh = mesh;
  trial->scene = scene_of(mesh);
  std::erase_if(rays, [](const Ray& ray) { return !is_valid(ray); });
  trial->rays = std::move(rays);
  trial->oracle = std::make_unique<oracle::SceneOracle>(SceneView{trial->scene->data()});
  trial->answers.resize(trial->rays.size());
  tbb::parallel_for(std::size_t{0}, trial->rays.size(),
                    [&](std::size_t i) { trial->answers[i] = trial->oracle->closest(trial->rays[i]); });
  return trial;
}

void judge(Exam& exam, const Trial& trial, const OptionValues& options) {
  const StructureRef structure = exam.build(trial.scene, options);
  const std::vector<Hit> hits = exam.closest(structure, trial.rays);
  const std::vector<u8> flags = exam.occluded(structure, trial.rays);
  exam.add_rays(trial.rays.size());
  std::vector<oracle::Verdict> verdicts(hits.size(), oracle::Verdict::right);
  tbb::parallel_for(std::size_t{0}, hits.size(), [&](std::size_t i) {
    const oracle::Answer& answer = trial.answers[i];
    if (answer.ray_class == oracle::RayClass::strict && answer.hit.id == hits[i].id) return;
    verdicts[i] = trial.oracle->judge(trial.rays[i], hits[i]).verdict;
  });
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const oracle::Answer& answer = trial.answers[i];
    if ((hits[i].id != kMiss) != (flags[i] != 0)) {
      exam.fail([&] {
        return Failure{trial.name + ": occluded is " + std::to_string(flags[i]) + ", closest " + text_of(hits[i]),
                       trial.rays[i], ring_around(trial.mesh, ids_of(answer, hits[i]))};
      });
      continue;
    }
    if (!oracle::is_acceptable(verdicts[i]))
      exam.fail([&] { return wrong_verdict(exam, trial, i, hits[i], verdicts[i]); });
  }
}

void same_as_brute(Exam& exam, const Trial& trial, const OptionValues& options) {
  if (!exam.strict() || exam.is_brute()) return;
  const std::vector<Hit> hits = exam.closest(exam.build(trial.scene, options), trial.rays);
  const std::vector<Hit> expected = exam.brute_force(trial.scene, trial.rays);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (same_bits(hits[i], expected[i])) continue;
    exam.fail([&] {
      const std::vector<u32> ids = {hits[i].id, expected[i].id};
      return Failure{trial.name + ": given " + text_of(hits[i]) + ", by brute force " + text_of(expected[i]),
                     trial.rays[i], ring_around(trial.mesh, ids), [&exam](const Ray& ray, const Mesh& triangles) {
                       return !same_bits(exam.closest_among(triangles, {ray}).front(),
                                         exam.brute_force(scene_of(triangles), {ray}).front());
                     }};
    });
  }
}

void judge_and_compare(Exam& exam, const Trial& trial, const OptionValues& options) {
  judge(exam, trial, options);
  same_as_brute(exam, trial, options);
}

void meets(Exam& exam, const SceneBlob& scene, const std::vector<Ray>& rays, u32 times) {
  const StructureRef structure = exam.build(scene);
  exam.add_rays(rays.size());
  const std::vector<u8> flags = exam.occluded(structure, rays);
  std::vector<Ray> rest = rays;
  std::vector<u8> failed(rays.size(), 0);
  for (u32 met = 0; met <= times; ++met) {
    const std::vector<Hit> hits = exam.closest(structure, rest);
    if (met == 0 && exam.is_brute()) no_hidden_neighbours(exam, scene, rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (failed[i] != 0) continue;
      const bool hit = hits[i].id != kMiss;
      if (hit == (met < times) && (met != 0 || (flags[i] != 0) == hit)) {
        if (hit) rest[i] = behind(rest[i], hits[i]);
        continue;
      }
      failed[i] = 1;
      exam.fail([&] {
        const std::string number =
            std::to_string(met) + (hit ? " or more" : "") + " hits instead of " + std::to_string(times);
        return wrong_number(exam, scene, rays[i], hits[i], number);
      });
    }
  }
}

void misses(Exam& exam, const SceneBlob& scene, const std::vector<Ray>& rays) {
  const StructureRef structure = exam.build(scene);
  const std::vector<Hit> hits = exam.closest(structure, rays);
  const std::vector<u8> flags = exam.occluded(structure, rays);
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].id == kMiss && flags[i] == 0) continue;
    exam.fail([&] {
      const std::vector<u32> ids = {hits[i].id};
      return Failure{"a hit where there is none, " + text_of(hits[i]), rays[i], ring_around(mesh_of(scene), ids),
                     [&exam](const Ray& ray, const Mesh& triangles) {
                       return exam.closest_among(triangles, {ray}).front().id != kMiss &&
                              !oracle::is_acceptable(verdict_among(exam, ray, triangles));
                     }};
    });
  }
}

void same_answers(Exam& exam, const StructureRef& structure, const std::vector<Ray>& rays, const std::vector<Ray>& as,
                  const std::string& what) {
  const std::vector<Hit> hits = exam.closest(structure, rays), others = exam.closest(structure, as);
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (same_bits(hits[i], others[i])) continue;
    exam.fail([&] {
      return Failure{what + ": " + text_of(hits[i]) + " and " + text_of(others[i]) + " of " + text_of(as[i]), rays[i]};
    });
  }
}

}  // namespace raywalk::accuracy
