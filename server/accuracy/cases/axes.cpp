// Axis-aligned meshes and rays with zeros in their directions.
#include <cmath>

#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {
namespace {

/// x becomes y, y becomes z, z becomes x, `times` times.
Vec3 cycled(Vec3 p, u32 times) {
  for (u32 i = 0; i < times; ++i) p = {p.z, p.x, p.y};
  return p;
}

float some_zero(Random& random) {
  return random.below(2) != 0 ? 0.0f : -0.0f;
}

/// The box [lo, hi], twelve triangles.
Mesh box(Vec3 lo, Vec3 hi) {
  Mesh mesh = subdivided_box(1, 0.0f, 1.0f);
  for (Corners& t : mesh)
    for (Vec3* p : {&t.a, &t.b, &t.c})
      *p = {p->x == 0.0f ? lo.x : hi.x, p->y == 0.0f ? lo.y : hi.y, p->z == 0.0f ? lo.z : hi.z};
  return mesh;
}

/// Four boxes of this size around the z axis, or two on both sides of the plane x = 0, with their front at z = 0; all
/// turned. Where boxes touch, no ray along z gets through.
Mesh boxes_around_axis(float size, bool four, u32 turns) {
  Mesh mesh;
  for (const float x : {-size, 0.0f})
    for (const float y : {-size, 0.0f})
      if (four || y == 0.0f) append(mesh, box({x, y, 0.0f}, {x + size, y + size, size}));
  for (Corners& t : mesh)
    for (Vec3* p : {&t.a, &t.b, &t.c}) *p = cycled(*p, turns);
  return mesh;
}

/// Each ray hits, at this distance up to two ulps.
void hits_at(Exam& exam, const SceneBlob& scene, const std::vector<Ray>& rays, float distance) {
  const std::vector<Hit> hits = exam.closest(exam.build(scene), rays);
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].id != kMiss && std::abs(hits[i].t - distance) <= distance * 0x1p-22f) continue;
    exam.fail([&] {
      return Failure{"given " + text_of(hits[i]) + ", expected t " + text_of(distance), rays[i], mesh_of(scene),
                     [&exam, distance](const Ray& ray, const Mesh& triangles) {
                       const Hit hit = exam.closest_among(triangles, {ray}).front();
                       const oracle::Answer exact = oracle::SceneOracle({scene_of(triangles)->data()}).closest(ray);
                       return exact.is_hit() && exact.hit.t == distance && hit.id == kMiss;
                     }};
    });
  }
}

/// Rays along z of boxes 1e-4 to 1, from origins whose x, and y if `on_edge`, is 0: before the boxes and inside them.
void along_boxes(Exam& exam, bool on_edge) {
  Random random = exam.random(1);
  const u32 count = exam.count(on_edge ? 2'000 : 10'000);
  for (const float size : {1e-4f, 3e-4f, 1e-3f, 1e-2f, 0.1f, 0.3f, 1.0f}) {
    for (u32 turns = 0; turns < 3; ++turns) {
      const SceneBlob& scene = exam.store().get(text_of(size) + std::to_string(turns),
                                                [&] { return scene_of(boxes_around_axis(size, on_edge, turns)); });
      std::vector<Ray> before, inside;
      for (u32 i = 0; i < count; ++i) {
        const float y = on_edge ? some_zero(random) : random.uniform(0.01f, 0.99f) * size;
        const Vec3 d{some_zero(random), some_zero(random), 1.0f};
        const float x = some_zero(random);
        before.push_back({cycled({x, y, -size}, turns), 0.0f, cycled(d, turns), kFarAway});
        inside.push_back({cycled({x, y, 0.5f * size}, turns), 0.0f, cycled(d, turns), kFarAway});
      }
      hits_at(exam, scene, before, size);
      hits_at(exam, scene, inside, 0.5f * size);
    }
  }
}

}  // namespace

void in_face_planes(Exam& exam) {
  along_boxes(exam, false);
}

void along_box_edges(Exam& exam) {
  along_boxes(exam, true);
}

void signed_zeros(Exam& exam) {
  for (const char* name : {"sphere", "box"}) {
    const Mesh& mesh = exam.store().get(
        name, [&] { return std::string_view(name) == "box" ? subdivided_box(8) : icosphere(4, 2.0f); });
    const SceneBlob& scene = exam.store().get(std::string(name) + " scene", [&] { return scene_of(mesh); });
    const u32 count = exam.count(20'000);
    std::vector<Ray> plus = axis_rays(exam.seed(1), count, mesh);
    for (Ray& ray : random_rays(exam.seed(2), count, bounds_of(mesh))) {
      ray.d.y = 0.0f;
      plus.push_back(ray);
    }
    std::vector<Ray> minus = plus;
    for (std::size_t i = 0; i < plus.size(); ++i) {
      for (float Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        if (plus[i].d.*component != 0.0f) continue;
        plus[i].d.*component = 0.0f;
        minus[i].d.*component = -0.0f;
      }
    }
    same_answers(exam, exam.build(scene), plus, minus, "+0 and -0");
  }
}

void coplanar_rays(Exam& exam) {
  Random random = exam.random(1);
  for (u32 axis = 0; axis < 3; ++axis) {
    for (const float height : {0.0f, 0.3f, -7.0f}) {
      const SceneBlob& scene = exam.store().get(std::to_string(axis) + text_of(height),
                                                [&] { return scene_of(quad_grid(4, axis, height)); });
      std::vector<Ray> rays;
      for (u32 i = 0; i < exam.count(3'000); ++i) {
        Ray ray{random.in_box({-2, -2, -2}, {2, 2, 2}), 0.0f, random.direction(), kFarAway};
        if (random.below(4) == 0) ray.d = {1.0f, some_zero(random), -1.0f};
        (axis == 0 ? ray.o.x : axis == 1 ? ray.o.y : ray.o.z) = height;
        (axis == 0 ? ray.d.x : axis == 1 ? ray.d.y : ray.d.z) = some_zero(random);
        if (is_valid(ray)) rays.push_back(ray);
      }
      misses(exam, scene, rays);
    }
  }
}

void one_flat_quad(Exam& exam) {
  for (u32 axis = 0; axis < 3; ++axis) {
    for (const float offset : {0.0f, 1.0f, 1e2f, 1e4f, 1e6f}) {
      const SceneBlob& scene = exam.store().get(std::to_string(axis) + text_of(offset), [&] {
        return scene_of(transformed(quad_grid(1, axis), 1.0f, {offset, -offset, offset}));
      });
      const Vec3 centre{offset, -offset, offset};
      Random random = exam.random(axis);
      std::vector<Ray> rays;
      for (u32 i = 0; i < exam.count(5'000); ++i) {
        const float p = random.uniform(-0.8f, 0.8f);
        const float q = random.below(2) != 0 ? p : random.uniform(-0.8f, 0.8f);  // on the diagonal, or anywhere
        const float height = random.below(2) != 0 ? 3.0f : -3.0f;
        const Vec3 side = random.below(4) == 0 ? Vec3{0, 0, 0} : random.in_box({-0.7f, -0.7f, 0}, {0.7f, 0.7f, 0});
        const Vec3 target = cycled({p, q, 0}, axis + 1), from = cycled({p + side.x, q + side.y, height}, axis + 1);
        rays.push_back(ray_towards(from + centre, target + centre));
      }
      meets(exam, scene, rays);
    }
  }
}

void lattice_of_cubes(Exam& exam) {
  const SceneBlob& scene = exam.store().get("cubes", [] {
    Mesh mesh;
    for (u32 i = 0; i < 512; ++i) {
      const Vec3 lo{static_cast<float>(i % 8), static_cast<float>(i / 8 % 8), static_cast<float>(i / 64)};
      append(mesh, box(lo, lo + Vec3{1, 1, 1}));
    }
    return scene_of(mesh);
  });
  Random random = exam.random(1);
  std::vector<Ray> straight;
  for (u32 i = 0; i < exam.count(20'000); ++i) {
    const u32 turns = random.below(3);
    const float x = static_cast<float>(1 + random.below(7));
    const float y = random.below(2) != 0 ? static_cast<float>(1 + random.below(7)) : random.uniform(0.1f, 7.9f);
    straight.push_back(
        {cycled({x, y, -2.0f}, turns), 0.0f, cycled({some_zero(random), some_zero(random), 1.0f}, turns), kFarAway});
  }
  hits_at(exam, scene, straight, 2.0f);
  judge_and_compare(exam, *exam.store().get("slanted", [&] {
    std::vector<Ray> slanted;
    for (u32 i = 0; i < exam.count(4'000); ++i) {
      const u32 turns = random.below(3);
      const Vec3 o{static_cast<float>(random.below(9)), static_cast<float>(random.below(9)),
                   random.below(2) != 0 ? -2.0f : static_cast<float>(random.below(9))};
      const Vec3 d{some_zero(random), static_cast<float>(random.below(5)) - 2.0f, static_cast<float>(random.below(3))};
      slanted.push_back({cycled(o, turns), 0.0f, cycled(d, turns), kFarAway});
    }
    return make_trial("in the planes", mesh_of(scene), slanted);
  }));
}

void lattice_directions(Exam& exam) {
  judge_and_compare(exam, *exam.store().get("trial", [&] {
    Random random = exam.random(1);
    std::vector<Ray> rays;
    for (u32 i = 0; i < exam.count(20'000); ++i) {
      const auto at = [&] { return 0.5f * static_cast<float>(random.below(17)); };
      const auto way = [&] {
        const float d = static_cast<float>(random.below(7)) - 3.0f;
        return d == 0.0f ? some_zero(random) : d;
      };
      const Vec3 o{at(), at(), at()};
      rays.push_back({o, 0.0f, {way(), way(), way()}, kFarAway});
    }
    return make_trial("lattice", integer_lattice(exam.seed(2), 600, 8), rays);
  }));
}

}  // namespace raywalk::accuracy
