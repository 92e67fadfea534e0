// Scenes of any size and place, thin triangles, directions of any length.
#include <algorithm>
#include <cmath>

#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/placed.h"

namespace raywalk::accuracy {
namespace {

/// Triangle tests work between these powers of two: with edges of the sphere a tenth as long, what Kahan's difference
/// of products leaves of a squared edge is still a float, and so is the square of the whole sphere.
constexpr int kSmallestScale = -44, kLargestScale = 58;

std::vector<Ray> rays_at_sphere(Exam& exam, const Mesh& mesh, const std::vector<Vec3>& from, u32 count, u32 stream) {
  Random random = exam.random(stream);
  std::vector<Ray> rays;
  for (u32 i = 0; i < count; ++i) {
    const Vec3 origin = from[random.below(static_cast<u32>(from.size()))];
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const u32 place = random.below(3);
    rays.push_back(random.below(2) != 0 ? ray_to_vertex(origin, t, place)
                                        : ray_to_edge(origin, t, place, random.uniform()));
  }
  return rays;
}

/// What becomes of a hit when its distances are multiplied.
bool is_scaled(const Hit& hit, const Hit& of, float by) {
  if (of.id == kMiss) return hit.id == kMiss;
  return hit.id == of.id && hit.t == of.t * by && hit.u == of.u && hit.v == of.v;
}

/// True for Embree, which is not asked then.
bool ends_the_process(Exam& exam) {
  if (exam.technique().structure != "embree") return false;
  exam.does_not_apply("Embree's assertions end the process at the ends of the range of floats");
  return true;
}

}  // namespace

void far_from_the_origin(Exam& exam) {
  for (int k = 0; k <= 7; ++k) {
    const float offset = std::pow(10.0f, static_cast<float>(k));
    const Placed& sphere = exam.store().get("sphere " + std::to_string(k), [&] {
      return placed("sphere", icosphere(4, 2.0f), 1.0f, offset, 0.5f, exam.random(1));
    });
    if (!sphere.inside.empty()) {
      meets(exam, sphere.scene, rays_at_sphere(exam, sphere.mesh, sphere.inside, exam.count(20'000), 2));
      continue;
    }
    judge_and_compare(exam, *exam.store().get("trial " + std::to_string(k), [&] {
      return make_trial(sphere.name, sphere.mesh,
                        rays_at_sphere(exam, sphere.mesh, {sphere.centre}, exam.count(4'000), 2));
    }));
  }
}

void scaled_scenes(Exam& exam) {
  if (ends_the_process(exam)) return;
  constexpr float kRadius = 2.0f;
  const Mesh& mesh = exam.store().get("mesh", [] { return icosphere(3, kRadius); });
  std::vector<Ray> rays = edge_rays(exam.seed(1), exam.count(3'000), mesh);
  for (const Ray& ray : random_rays(exam.seed(2), exam.count(3'000), bounds_of(mesh))) rays.push_back(ray);
  const auto scene = [&](int k) -> const SceneBlob& {
    return exam.store().get("scene " + std::to_string(k),
                            [&] { return scene_of(transformed(mesh, std::ldexp(1.0f, k), {})); });
  };
  const std::vector<Hit> hits = exam.closest(exam.build(scene(0)), rays);
  for (const int k : {-66, -60, -52, kSmallestScale, -30, -10, -1, 1, 10, 30, kLargestScale, 60}) {
    const float by = std::ldexp(1.0f, k);
    std::vector<Ray> scaled = rays;
    for (Ray& ray : scaled) {
      ray.o = ray.o * by;
      ray.tmax = kMaxFloat;
    }
    const std::vector<Hit> others = exam.closest(exam.build(scene(k)), scaled);
    exam.add_rays(rays.size());
    const bool within = k >= kSmallestScale && k <= kLargestScale;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      // Outside the range a hit may get lost, or go to another triangle, but stays on the sphere.
      const Vec3 unscaled = rays[i].o + rays[i].d * (others[i].t / by);
      const bool lost = others[i].id == kMiss || (hits[i].id != kMiss && std::abs(length(unscaled) - kRadius) < 0.1f);
      if (within ? is_scaled(others[i], hits[i], by) : lost) continue;
      exam.fail([&] {
        return Failure{
            "scale 2^" + std::to_string(k) + ": given " + text_of(others[i]) + ", unscaled " + text_of(hits[i]),
            rays[i], ring_around(mesh, {hits[i].id})};
      });
    }
  }
}

void sliver_triangles(Exam& exam) {
  judge_and_compare(exam, *exam.store().get("trial", [&] {
    Random random = exam.random(1);
    Mesh mesh;
    std::vector<Ray> rays;
    for (u32 i = 0; i < 500; ++i) {
      const Vec3 p = random.in_box({-1, -1, -1}, {1, 1, 1}), q = p + random.direction();
      mesh.push_back(triangle(p, p + random.direction() * 1e-6f, q));
      for (u32 k = 0; k < exam.count(60, 4); ++k) {
        const float along = random.uniform();
        rays.push_back(ray_towards(random.in_box({-3, -3, -3}, {3, 3, 3}), p * (1.0f - along) + q * along));
      }
    }
    return make_trial("slivers", mesh, rays);
  }));
}

void needle_triangle(Exam& exam) {
  Random random = exam.random(1);
  for (u32 turn = 0; turn < 20; ++turn) {
    const Vec3 a = random.in_box({-2, -2, -2}, {2, 2, 2}), along = random.direction();
    const Vec3 side = normalized(cross(along, random.direction()));
    constexpr float kAngle = 0.52f * std::numbers::pi_v<float> / 180.0f;
    const Corners needle =
        triangle(a, a + along * 11.2f, a + (along * std::cos(kAngle) + side * std::sin(kAngle)) * 9.7f);
    const SceneBlob& scene = exam.store().get(std::to_string(turn), [&] { return scene_of({needle}); });
    std::vector<Ray> rays;
    for (u32 i = 0; i < exam.count(2'000); ++i) {
      const float u = random.uniform(), v = random.uniform(0.0f, 1.0f - u);
      const Vec3 target = needle.a * (1.0f - u - v) + needle.b * u + needle.c * v;
      const float away = random.below(2) != 0 ? 10.0f : 0.1f;
      // Grazing rays are the hard ones.
      const Vec3 from = target + along * (random.uniform(-1.0f, 1.0f) * away) + random.direction() * (0.01f * away);
      rays.push_back(ray_towards(from, target));
    }
    const std::vector<Hit> hits = exam.closest(exam.build(scene), rays);
    exam.add_rays(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i].id == kMiss) continue;
      const Ray& ray = rays[i];
      // Along the axis in which the ray is longest, hits lie between the vertices.
      const Vec3 m = magnitude(ray.d);
      const u32 axis = m.x > m.y ? (m.x > m.z ? 0u : 2u) : (m.y > m.z ? 1u : 2u);
      const auto distance = [&](Vec3 p) { return (double{p[axis]} - double{ray.o[axis]}) / double{ray.d[axis]}; };
      const auto [low, high] = std::minmax({distance(needle.a), distance(needle.b), distance(needle.c)});
      const double slack = 0x1p-22 * std::max(std::abs(low), std::abs(high));
      if (hits[i].t >= low - slack && hits[i].t <= high + slack) continue;
      exam.fail([&] { return Failure{"beyond the vertices, " + text_of(hits[i]), ray, {needle}}; });
    }
  }
}

void origins_far_away(Exam& exam) {
  judge_and_compare(exam, *exam.store().get("trial", [&] {
    const Mesh mesh = icosphere(4, 2.0f);
    std::vector<Ray> rays = edge_rays(exam.seed(1), exam.count(4'000), mesh, 3e4f);
    for (const Ray& ray : vertex_rays(exam.seed(2), exam.count(4'000), mesh, 3e4f)) rays.push_back(ray);
    return make_trial("1e5 away", mesh, rays);
  }));
}

void direction_lengths(Exam& exam) {
  if (ends_the_process(exam)) return;
  const Mesh& mesh = exam.store().get("mesh", [] { return icosphere(4, 2.0f); });
  const SceneBlob& scene = exam.store().get("scene", [&] { return scene_of(mesh); });
  const StructureRef structure = exam.build(scene);
  std::vector<Ray> rays = edge_rays(exam.seed(1), exam.count(3'000), mesh);
  // Components that are multiples of 2^-9, so that a direction of length 2^-110 still holds all their bits.
  for (Ray& ray : rays)
    ray.d = {std::nearbyint(ray.d.x * 512) / 512, std::nearbyint(ray.d.y * 512) / 512,
             std::nearbyint(ray.d.z * 512) / 512};
  for (Ray& ray : random_rays(exam.seed(2), exam.count(3'000), bounds_of(mesh))) {
    ray.d = {std::nearbyint(ray.d.x * 512) / 512, std::nearbyint(ray.d.y * 512) / 512, 1.0f};
    rays.push_back(ray);
  }
  std::erase_if(rays, [](const Ray& ray) { return !is_valid(ray); });
  for (Ray& ray : rays) ray.tmax = kMaxFloat;
  const std::vector<Hit> hits = exam.closest(structure, rays);
  for (const int k : {-110, -90, -60, -30, -3, 3, 30, 60, 90, 110}) {
    std::vector<Ray> scaled = rays;
    for (Ray& ray : scaled) ray.d = ray.d * std::ldexp(1.0f, k);
    const std::vector<Hit> others = exam.closest(structure, scaled);
    exam.add_rays(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (is_scaled(others[i], hits[i], std::ldexp(1.0f, -k))) continue;
      exam.fail([&] {
        return Failure{
            "length 2^" + std::to_string(k) + ": given " + text_of(others[i]) + ", before " + text_of(hits[i]),
            scaled[i], ring_around(mesh, {hits[i].id})};
      });
    }
  }
  // Of denormal directions distances leave the floats: a miss or a hit of the same triangle, nothing else.
  std::vector<Ray> denormal = rays;
  for (Ray& ray : denormal) ray.d = ray.d * 0x1p-140f;
  std::erase_if(denormal, [](const Ray& ray) { return !is_valid(ray); });
  for (const Hit& hit : exam.closest(structure, denormal))
    if (hit.id != kMiss && !is_finite(hit.t)) exam.fail("a denormal direction gives " + text_of(hit));
  exam.add_rays(denormal.size());
}

}  // namespace raywalk::accuracy
