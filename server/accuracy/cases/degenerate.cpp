// Input that is no geometry: broken rays and vertices, points and lines, duplicates, and intervals that end at a hit.
#include <cmath>
#include <limits>

#include "server/accuracy/cases/case_list.h"
#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

/// Each way to make a ray invalid.
std::vector<Ray> invalid_versions(const Ray& ray) {
  std::vector<Ray> versions;
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (float Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      versions.insert(versions.end(), 2, ray);
      versions[versions.size() - 2].o.*component = bad;
      versions.back().d.*component = bad;
    }
    versions.insert(versions.end(), 2, ray);
    versions[versions.size() - 2].tmin = bad;
    versions.back().tmax = bad;
  }
  for (const Vec3 none : {Vec3{0.0f, 0.0f, 0.0f}, Vec3{-0.0f, 0.0f, -0.0f}}) {
    versions.push_back(ray);
    versions.back().d = none;
  }
  return versions;
}

std::vector<Ray> mixed_rays(Exam& exam, u32 count, const Mesh& mesh) {
  std::vector<Ray> rays = random_rays(exam.seed(1), count, bounds_of(mesh));
  for (const auto& more : {edge_rays(exam.seed(2), count, mesh), vertex_rays(exam.seed(3), count, mesh)})
    rays.insert(rays.end(), more.begin(), more.end());
  return rays;
}

}  // namespace

void hardly_any_triangles(Exam& exam) {
  const std::vector<Ray> rays = random_rays(exam.seed(1), exam.count(5'000), {{0, 0, 0}, {2, 3, 4}});
  const Corners point = triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), line = triangle({1, 2, 3}, {2, 3, 4}, {3, 4, 5});
  misses(exam, exam.store().get("none", [] { return scene_of({}); }), rays);
  misses(exam, exam.store().get("points", [&] { return scene_of(Mesh(5, point)); }), rays);
  misses(exam, exam.store().get("lines", [&] { return scene_of({line, point, line}); }), rays);
  misses(exam,
         exam.store().get("no numbers",
                          [] {
                            return scene_of(Mesh(5, triangle({kNan, 0, 0}, {}, {1, 0, 0})));
                          }),
         rays);
  judge_and_compare(exam, *exam.store().get("one", [&] {
    const Mesh one = {triangle({0, 0, 1}, {2, 0, 2}, {0, 3, 3})};
    return make_trial("one triangle", one, mixed_rays(exam, exam.count(3'000), one));
  }));
}

void invalid_rays(Exam& exam) {
  const SceneBlob& scene = exam.store().get("scene", [] { return scene_of(icosphere(3)); });
  const StructureRef structure = exam.build(scene);
  std::vector<Ray> valid, mixed;
  std::vector<std::size_t> place;  // of the valid rays among all
  for (const Ray& ray : random_rays(exam.seed(1), exam.count(1'000), {{-1, -1, -1}, {1, 1, 1}})) {
    for (const Ray& bad : invalid_versions(ray)) mixed.push_back(bad);
    place.push_back(mixed.size());
    mixed.push_back(ray);
    valid.push_back(ray);
  }
  const std::vector<Hit> hits = exam.closest(structure, mixed), expected = exam.closest(structure, valid);
  const std::vector<u8> flags = exam.occluded(structure, mixed);
  exam.add_rays(mixed.size());
  for (std::size_t i = 0, next = 0; i < mixed.size(); ++i) {
    const bool is_good = next < place.size() && place[next] == i;
    const bool right = is_good ? same_bits(hits[i], expected[next]) : hits[i].id == kMiss && flags[i] == 0;
    next += is_good ? 1 : 0;
    if (!right) exam.fail([&] { return Failure{"among invalid rays, given " + text_of(hits[i]), mixed[i]}; });
  }
}

void broken_vertices(Exam& exam) {
  judge_and_compare(exam, *exam.store().get("trial", [&] {
    const Mesh whole = icosphere(3);
    Mesh mesh = whole;
    for (u32 i = 0; i < mesh.size(); i += 7) mesh[i].b.y = kNan;
    for (u32 i = 1; i < mesh.size(); i += 7) mesh[i].c.x = i % 2 != 0 ? kInfinity : -kInfinity;
    for (u32 i = 2; i < mesh.size(); i += 21) mesh[i].a = {kInfinity, -kInfinity, kNan};
    return make_trial("broken vertices", mesh, mixed_rays(exam, exam.count(3'000), whole));
  }));
}

void degenerate_triangles(Exam& exam) {
  Random random = exam.random(1);
  Mesh mesh;
  std::vector<Ray> rays;
  for (u32 i = 0; i < 200; ++i) {
    const auto whole = [&] { return static_cast<float>(random.below(64)) * 0.125f; };
    const Vec3 a{whole(), whole(), whole()}, b{whole(), whole(), whole()}, middle = 0.5f * a + 0.5f * b;
    const Corners kinds[] = {triangle(a, a, a), triangle(a, b, b), triangle(a, b, a), triangle(a, middle, b)};
    mesh.push_back(kinds[i % 4]);
    for (u32 k = 0; k < exam.count(100, 4); ++k) {
      const Vec3 from = random.below(2) != 0 ? Vec3{whole(), whole(), whole()} : random.in_box({-9, -9, -9}, {9, 9, 9});
      rays.push_back(ray_towards(from, random.below(2) != 0 ? a : middle));
    }
  }
  std::erase_if(rays, [](const Ray& ray) { return !is_valid(ray); });
  misses(exam, exam.store().get("scene", [&] { return scene_of(mesh); }), rays);
}

void ends_of_the_interval(Exam& exam) {
  const Mesh& mesh = exam.store().get("mesh", [] { return icosphere(4, 2.0f); });
  const SceneBlob& scene = exam.store().get("scene", [&] { return scene_of(mesh); });
  const StructureRef structure = exam.build(scene);
  const std::vector<Ray> rays = mixed_rays(exam, exam.count(10'000), mesh);
  const std::vector<Hit> hits = exam.closest(structure, rays);
  struct Change {
    const char* name;
    bool is_end;   // tmax moves, else tmin
    float toward;  // the hit's t, or its neighbour in this direction
    bool is_met;
  };
  const Change changes[] = {{"tmax = t", true, 0.0f, true},
                            {"tmax below t", true, -kMaxFloat, false},
                            {"tmin = t", false, 0.0f, true},
                            {"tmin above t", false, kMaxFloat, false}};
  for (const Change& change : changes) {
    std::vector<Ray> cut;
    std::vector<Hit> before;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i].id == kMiss) continue;
      const float t = change.toward == 0.0f ? hits[i].t : std::nextafter(hits[i].t, change.toward);
      cut.push_back(rays[i]);
      before.push_back(hits[i]);
      (change.is_end ? cut.back().tmax : cut.back().tmin) = t;
    }
    const std::vector<Hit> after = exam.closest(structure, cut);
    exam.add_rays(cut.size());
    for (std::size_t i = 0; i < cut.size(); ++i) {
      const bool kept = same_bits(after[i], before[i]);
      // Cut off, the next hit may come, but none outside the interval.
      const bool inside = after[i].id == kMiss || (after[i].t >= cut[i].tmin && after[i].t <= cut[i].tmax);
      if (inside && kept == change.is_met) continue;
      exam.fail([&] {
        return Failure{std::string(change.name) + ": given " + text_of(after[i]) + ", before " + text_of(before[i]),
                       cut[i],
                       {mesh[before[i].id]}};
      });
    }
  }
}

void duplicate_triangles(Exam& exam) {
  const Mesh& once = exam.store().get("mesh", [] { return icosphere(3); });
  const SceneBlob& scene = exam.store().get("scene", [&] {
    Mesh mesh;
    for (u32 i = 0; i < 5; ++i) append(mesh, once);
    return scene_of(mesh);
  });
  const SceneBlob& single = exam.store().get("single", [&] { return scene_of(once); });
  const std::vector<Ray> rays = mixed_rays(exam, exam.count(10'000), once);
  const std::vector<Hit> hits = exam.closest(exam.build(scene), rays),
                         expected = exam.closest(exam.build(single), rays);
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (same_bits(hits[i], expected[i])) continue;
    exam.fail([&] {
      return Failure{"given " + text_of(hits[i]) + ", without duplicates " + text_of(expected[i]), rays[i],
                     ring_around(once, {expected[i].id})};
    });
  }
}

}  // namespace raywalk::accuracy
