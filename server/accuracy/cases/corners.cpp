// Edges and vertices of surfaces that the ray comes from outside to: quads, fans, terrain, boxes.
#include <cmath>

#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {

void split_quad(Exam& exam) {
  const SceneBlob& scene = exam.store().get("quad", [] {
    return scene_of({triangle({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}), triangle({-5, -5, 0}, {5, 5, 0}, {-5, 5, 0})});
  });
  std::vector<Ray> rays = {ray_towards({0, 0, 10}, {3.375f, 3.375f, 0})};
  Random random = exam.random(1);
  for (u32 i = 0; i < exam.count(10'000); ++i) {
    const float along = random.uniform(-4.9f, 4.9f);
    const Vec3 from = random.below(2) != 0 ? Vec3{0, 0, 10} : random.in_box({-5, -5, 1}, {5, 5, 10});
    rays.push_back(ray_towards(from, {along, along, 0}));
  }
  meets(exam, scene, rays);
}

void fans(Exam& exam) {
  const u32 count = exam.count(100'000 / 9);
  for (u32 n = 4; n <= 1024; n *= 2) {
    Random random = exam.random(n);
    const Vec3 hub = random.in_box({-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f});
    std::vector<Vec3> rim;
    for (u32 i = 0; i < n; ++i) {
      const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(n);
      rim.push_back({std::cos(angle), std::sin(angle), random.uniform(-0.05f, 0.05f) * 4.0f / static_cast<float>(n)});
    }
    const SceneBlob& scene = exam.store().get("fan " + std::to_string(n), [&] {
      Mesh mesh;
      for (u32 i = 0; i < n; ++i) mesh.push_back(triangle(hub, rim[i], rim[(i + 1) % n]));
      return scene_of(mesh);
    });
    std::vector<Ray> rays;
    for (u32 i = 0; i < count; ++i) {
      const float along = random.below(2) != 0 ? 0.0f : random.uniform(0.0f, 0.9f);
      const Vec3 from = random.in_box({-0.3f, -0.3f, 2}, {0.3f, 0.3f, 4});
      rays.push_back(ray_towards(from, hub * (1.0f - along) + rim[random.below(n)] * along));
    }
    meets(exam, scene, rays);
  }
}

void terrain(Exam& exam) {
  constexpr u32 n = 32;
  Random heights = exam.random(0);
  const SceneBlob& scene = exam.store().get("terrain", [&] {
    std::vector<Vec3> points;
    for (u32 z = 0; z <= n; ++z)
      for (u32 x = 0; x <= n; ++x)
        points.push_back({static_cast<float>(x), static_cast<float>(heights.below(8)), static_cast<float>(z)});
    Mesh mesh;
    for (u32 z = 0; z < n; ++z) {
      for (u32 x = 0; x < n; ++x) {
        const Vec3 *near = &points[z * (n + 1) + x], *far = near + n + 1;
        mesh.push_back(triangle(near[0], far[0], far[1]));
        mesh.push_back(triangle(near[0], far[1], near[1]));
      }
    }
    return scene_of(mesh);
  });
  Random random = exam.random(1);
  std::vector<Ray> rays;
  const auto zero = [&] { return random.below(2) != 0 ? 0.0f : -0.0f; };
  for (u32 i = 0; i < exam.count(50'000); ++i) {
    const auto at = [&] { return 1.0f + 0.5f * static_cast<float>(random.below(2 * n - 3)); };
    rays.push_back({{at(), 20.0f, at()}, 0.0f, {zero(), -1.0f, zero()}, kFarAway});
  }
  meets(exam, scene, rays);
}

void nested_boxes(Exam& exam) {
  const Mesh& outer = exam.store().get("outer", [] { return subdivided_box(20, -30, 30); });
  const SceneBlob& scene = exam.store().get("boxes", [&] {
    Mesh mesh = subdivided_box(20, -20, 20);
    append(mesh, outer);
    return scene_of(mesh);
  });
  std::vector<Ray> rays;
  for (const Corners& t : outer)
    for (const Vec3 p : {t.a, t.b, t.c}) rays.push_back(ray_towards({0, 0, 0}, p));
  Random random = exam.random(1);
  while (rays.size() > exam.count(rays.size(), 1000)) {
    rays[random.below(static_cast<u32>(rays.size()))] = rays.back();
    rays.pop_back();
  }
  meets(exam, scene, rays, 2);
}

void t_junction(Exam& exam) {
  judge_and_compare(exam, *exam.store().get("trial", [&] {
    const Vec3 a{-1.0f, 0.1f, 0.3f}, b{1.0f, 0.7f, -0.2f}, middle = a * 0.3f + b * 0.7f;
    const Mesh mesh = {triangle(a, b, {0.3f, -1, 0}), triangle(a, middle, {-0.2f, 1.5f, 0.1f}),
                       triangle(middle, b, {-0.2f, 1.5f, 0.1f})};
    Random random = exam.random(1);
    std::vector<Ray> rays;
    for (u32 i = 0; i < exam.count(20'000); ++i) {
      const float along = random.uniform(0.02f, 0.98f);
      const Vec3 target = random.below(8) == 0 ? middle : a * (1.0f - along) + b * along;
      rays.push_back(ray_towards(random.in_box({-1, -1, 1}, {1, 1, 4}), target));
    }
    return make_trial("T-junction", mesh, rays);
  }));
}

}  // namespace raywalk::accuracy
