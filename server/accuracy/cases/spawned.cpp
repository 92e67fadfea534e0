// Rays that leave a surface do not meet it again, and still meet what is close.
#include <algorithm>
#include <cmath>

#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/spawned.h"
#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {
namespace {

constexpr u64 kBatch = u64{1} << 19;  // spawned rays at once

/// Hits of primary rays at random points inside random triangles of the mesh, from about its size away.
std::vector<Ray> primary_rays(const Mesh& mesh, u32 count, Random& random) {
  std::vector<Ray> rays;
  rays.reserve(count);
  for (u32 i = 0; i < count; ++i) {
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const float u = random.uniform(), v = random.uniform(0.0f, 1.0f - u);
    const Vec3 target = t.a * (1.0f - u - v) + t.b * u + t.c * v;
    const float size = largest(magnitude(t.b - t.a)) * random.uniform(0.5f, 10.0f);
    rays.push_back(ray_towards(target + random.direction() * size, target));
  }
  return rays;
}

/// Spawns `each` rays from each of `count` hits; `check(spawned, hit)` tells what is wrong with an answer, or nothing.
template <class Check>
void spawn_many(Exam& exam, const SceneBlob& scene, u64 count, Random random, Check check) {
  constexpr u32 kEach = 16;
  const StructureRef structure = exam.build(scene);
  const Mesh mesh = mesh_of(scene);
  const SpawnOrigin origin_at = spawn_origin_of(exam.technique());
  for (u64 done = 0; done < count;) {
    const u32 now = static_cast<u32>(std::min<u64>(kBatch / kEach, (count - done + kEach - 1) / kEach));
    const std::vector<Ray> primary = primary_rays(mesh, now, random);
    const std::vector<Hit> hits = exam.closest(structure, primary);
    std::vector<Ray> rays;
    std::vector<u32> from;
    rays.reserve(u64{now} * kEach);
    from.reserve(rays.capacity());
    for (u32 i = 0; i < now; ++i) {
      if (hits[i].id == kMiss) continue;
      const Surface surface = surface_at<0>({scene->data()}, hits[i], primary[i].d, 0.0f);
      for (u32 k = 0; k < kEach; ++k) {
        const Vec3 d = random.direction();
        rays.push_back({origin_at(surface, d), 0.0f, d, kMaxFloat});
        from.push_back(hits[i].id);
      }
    }
    const std::vector<Hit> next = exam.closest(structure, rays);
    exam.add_rays(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::string wrong = check(rays[i], mesh[from[i]], next[i]);
      if (wrong.empty()) continue;
      exam.fail([&] {
        return Failure{wrong + ", spawned on " + std::to_string(from[i]) + ", given " + text_of(next[i]),
                       rays[i],
                       {mesh[from[i]]}};
      });
    }
    done += u64{now} * kEach;
  }
}

std::string met_itself(const Ray&, const Corners& from, const Hit& hit) {
  return hit.id == from.id ? "meets itself" : "";
}

/// Level 2: brute force is asked as well.
Mesh coarse_sphere(float radius) {
  return icosphere(2, radius);
}

}  // namespace

SpawnOrigin spawn_origin_of(const Technique& technique) {
  return raywalk::spawn_origin_of(knobs_of(technique.kernel).spawn);
}

void spawned_at_all_sizes(Exam& exam) {
  constexpr u32 kDecades = 17, kTriangles = 1000 / kDecades + 1;
  for (u32 decade = 0; decade < kDecades; ++decade) {
    const float size = std::pow(10.0f, static_cast<float>(decade) - 8.0f);
    const SceneBlob& scene = exam.store().get(std::to_string(decade), [&] {
      return scene_of(transformed(random_soup(exam.seed(decade), kTriangles, 0.5f), size, Vec3{3, -2, 1} * size));
    });
    spawn_many(exam, scene, exam.own_count(4'000'000 / kDecades), exam.random(100 + decade), met_itself);
  }
}

void close_shells(Exam& exam) {
  const Mesh& inner = exam.store().get("inner", [] { return coarse_sphere(1.0f); });
  const SceneBlob& scene = exam.store().get("shells", [&] {
    Mesh mesh = inner;
    append(mesh, coarse_sphere(1.0f + 4e-5f));
    return scene_of(mesh);
  });
  const u32 shell = static_cast<u32>(inner.size());
  spawn_many(exam, scene, exam.own_count(3'000'000), exam.random(1),
             [&](const Ray& ray, const Corners& from, const Hit& hit) {
               if (hit.id == from.id) return std::string("meets itself");
               const double side = double{dot(ray.d, from.a)};  // the facet faces away from the centre
               if (std::abs(side) < 0.3) return std::string();  // grazing: it may be beside the facet
               const bool outward = side > 0;
               if (from.id >= shell) return std::string(outward == (hit.id == kMiss) ? "" : "passes the inner shell");
               if (outward) return std::string(hit.id != kMiss && hit.id >= shell ? "" : "passes the outer shell");
               return std::string(hit.id < shell ? "" : "passes the inner shell's far side");
             });
}

void seen_from_afar(Exam& exam) {
  const SceneBlob& scene = exam.store().get("rectangle", [] { return scene_of(quad_grid(1)); });
  const StructureRef structure = exam.build(scene);
  const SpawnOrigin origin_at = spawn_origin_of(exam.technique());
  const Vec3 light{0.3f, 0.2f, 2.0f};
  for (int k = 0; k <= 7; ++k) {
    Random random = exam.random(static_cast<u32>(k));
    std::vector<Ray> primary, shadow;
    for (u32 i = 0; i < exam.count(10'000); ++i) {
      const Vec3 target = random.in_box({-0.9f, -0.9f, 0}, {0.9f, 0.9f, 0});
      const Vec3 way = random.in_box({-1, -1, 0.3f}, {1, 1, 1});
      primary.push_back(ray_towards(target + way * std::pow(10.0f, static_cast<float>(k)), target));
    }
    const std::vector<Hit> hits = exam.closest(structure, primary);
    for (std::size_t i = 0; i < primary.size(); ++i) {
      if (hits[i].id == kMiss) continue;  // from 1e7 away the last bit of the direction is as wide as the rectangle
      const Surface surface = surface_at<0>({scene->data()}, hits[i], primary[i].d, 0.0f);
      const Vec3 origin = origin_at(surface, light - surface.position);
      shadow.push_back({origin, 0.0f, light - origin, 1.0f});
    }
    const std::vector<u8> dark = exam.occluded(structure, shadow);
    exam.add_rays(shadow.size());
    for (std::size_t i = 0; i < shadow.size(); ++i)
      if (dark[i] != 0) exam.fail([&] { return Failure{"shadow on a lit rectangle", shadow[i], mesh_of(scene)}; });
  }
}

void spawned_far_from_the_origin(Exam& exam) {
  for (int decade = 0; decade <= 5; ++decade) {
    for (int k = 0; k <= 4; k += 2) {
      const float scale = std::pow(10.0f, static_cast<float>(decade));
      const float offset = scale * std::pow(10.0f, static_cast<float>(2 - k));
      const SceneBlob& scene = exam.store().get(std::to_string(decade) + " " + std::to_string(k), [&] {
        return scene_of(transformed(coarse_sphere(1.0f), scale, Vec3{1, -0.3f, 0.5f} * offset));
      });
      const u32 stream = static_cast<u32>(10 * decade + k);
      spawn_many(exam, scene, exam.own_count(3'000'000 / 18), exam.random(stream), met_itself);
    }
  }
}

}  // namespace raywalk::accuracy
