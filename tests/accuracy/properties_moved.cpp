// Properties of a scene and its rays that are mirrored, turned, moved or put in another order together.
#include <algorithm>
#include <cmath>
#include <functional>

#include "server/accuracy/cases/hex.h"
#include "tests/accuracy/properties.h"
#include "tests/accuracy/properties_agree.h"

namespace raywalk::accuracy {
namespace {

/// A scene and its rays put otherwise, and whether an answer after that goes with the one before.
struct Move {
  std::string name;
  std::function<Mesh(Mesh)> mesh;
  std::function<Ray(Ray)> ray;
  std::function<bool(const Answered& before, const Answered& after, bool sealed)> agree;
};

Ray same_ray(Ray ray) {
  return ray;
}

/// Applied to each vertex.
std::function<Mesh(Mesh)> each_vertex(std::function<Vec3(Vec3)> map) {
  return [map](Mesh mesh) {
    for (Corners& t : mesh)
      for (Vec3* p : {&t.a, &t.b, &t.c}) *p = map(*p);
    return mesh;
  };
}

/// Applied to origin and direction.
std::function<Ray(Ray)> both_vectors(std::function<Vec3(Vec3)> map) {
  return [map](Ray ray) {
    ray.o = map(ray.o);
    ray.d = map(ray.d);
    return ray;
  };
}

Failure broken(Exam& exam, const Shape& shape, const Move& move, const Answered& before, const Answered& after) {
  const std::string what = shape.name + ", " + move.name + ": given " + text_of(after.hit) + " for " +
                           std::to_string(after.id()) + ", before " + text_of(before.hit);
  return {what, before.ray, ring_around(shape.mesh, {before.id(), after.id()}),
          [&exam, &move](const Ray& ray, Mesh triangles) {
            for (u32 i = 0; i < triangles.size(); ++i) triangles[i].id = i;
            const Mesh moved = move.mesh(triangles);
            const Ray moved_ray = move.ray(ray);
            return !move.agree({ray, triangles, exam.closest_among(triangles, {ray}).front()},
                               {moved_ray, moved, exam.closest_among(moved, {moved_ray}).front()}, false);
          }};
}

void holds_after(Exam& exam, const Shape& shape, const Move& move) {
  const Mesh& mesh = exam.store().get(shape.name + move.name, [&] { return move.mesh(shape.mesh); });
  const SceneBlob& scene = exam.store().get(shape.name + move.name + " scene", [&] { return scene_of(mesh); });
  std::vector<Ray> rays;
  for (const Ray& ray : shape.rays) rays.push_back(move.ray(ray));
  const std::vector<Hit> hits = exam.closest(exam.build(scene_of(exam, shape)), shape.rays);
  const std::vector<Hit> others = exam.closest(exam.build(scene), rays);
  exam.add_rays(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Answered before{shape.rays[i], shape.mesh, hits[i]}, after{rays[i], mesh, others[i]};
    const bool lost = shape.sealed && exam.strict() && !(before.is_hit() && after.is_hit());
    if (lost || !move.agree(before, after, shape.sealed))
      exam.fail([&] { return broken(exam, shape, move, before, after); });
  }
}

bool is_strict_test(std::string_view intersector) {
  return intersector == "watertight" || intersector == "exact";
}

/// A technique whose traversal or rounding keeps none of what strict ones keep here.
bool only_for_strict(Exam& exam, const char* why) {
  if (exam.strict()) return false;
  exam.does_not_apply(why);
  return true;
}

}  // namespace

/// Mirrored at a coordinate plane, or at all three, a hit keeps the bits of t, u, v and its id: signs change, no
/// rounding does. Only a strict test's hit on an edge or vertex may go to its neighbour, which is chosen by directions
/// in space. The watertight test mirrored along the ray's main axis takes its products in another order: there t, u and
/// v change by their rounding, but never hit or miss.
void mirrored(Exam& exam) {
  if (may_lose_hits(exam)) return;
  const std::string_view test = intersector_of(exam.technique());
  const std::pair<const char*, Vec3> mirrors[] = {
      {"x", {-1, 1, 1}}, {"y", {1, -1, 1}}, {"z", {1, 1, -1}}, {"xyz", {-1, -1, -1}}};
  for (const Shape& shape : shapes()) {
    for (const auto& mirror : mirrors) {
      const Vec3 sign = mirror.second;
      const auto map = [sign](Vec3 p) { return p * sign; };
      holds_after(exam, shape,
                  {std::string("mirrored ") + mirror.first, each_vertex(map), both_vectors(map),
                   [=](const Answered& before, const Answered& after, bool sealed) {
                     const bool rounds = test == "watertight" && sign[main_axis(before.ray.d)] < 0.0f;
                     if (rounds ? same_up_to_rounding(test, before, after)
                                : before.id() == after.id() && same_numbers(before.hit, after.hit))
                       return true;
                     return is_strict_test(test) && new_owner(test, before, after, sealed);
                   }});
    }
  }
}

/// With its axes renamed a hit of a strict test keeps its id, and t, u, v up to their rounding, unless it lies on an
/// edge or vertex, which may go to the neighbour. Renamed in a cycle the watertight test keeps all bits, there too. The
/// other tests add up their components in an order of their own, so that their edges move.
void permuted_axes(Exam& exam) {
  if (only_for_strict(exam, "sums of components are rounded in the order of the axes")) return;
  const std::string_view test = intersector_of(exam.technique());
  struct Renaming {
    const char* name;
    Vec3 (*map)(Vec3);
    bool cyclic;
  };
  const Renaming renamings[] = {{"zxy",
                                 [](Vec3 p) {
                                   return Vec3{p.z, p.x, p.y};
                                 },
                                 true},
                                {"yzx",
                                 [](Vec3 p) {
                                   return Vec3{p.y, p.z, p.x};
                                 },
                                 true},
                                {"yxz",
                                 [](Vec3 p) {
                                   return Vec3{p.y, p.x, p.z};
                                 },
                                 false},
                                {"zyx",
                                 [](Vec3 p) {
                                   return Vec3{p.z, p.y, p.x};
                                 },
                                 false}};
  for (const Shape& shape : shapes()) {
    for (const Renaming& renaming : renamings) {
      holds_after(exam, shape,
                  {renaming.name, each_vertex(renaming.map), both_vectors(renaming.map),
                   [=](const Answered& before, const Answered& after, bool sealed) {
                     if (renaming.cyclic && test == "watertight")
                       return before.id() == after.id() && same_bits(before.hit, after.hit);
                     return same_up_to_rounding(test, before, after) || new_owner(test, before, after, sealed);
                   }});
    }
  }
}

/// With the winding of all triangles turned, or of every second one, a hit of a strict test keeps its id, also on an
/// edge or vertex; t, u and v, the latter two exchanged, keep up to their rounding. The other tests round each edge by
/// the triangle's first corner and its order.
void turned_windings(Exam& exam) {
  if (only_for_strict(exam, "what happens near an edge depends on the order of the corners")) return;
  const std::string_view test = intersector_of(exam.technique());
  for (const Shape& shape : shapes()) {
    for (const u32 every : {1u, 2u}) {
      holds_after(exam, shape,
                  {"every " + std::to_string(every) + " turned",
                   [every](Mesh mesh) {
                     for (Corners& t : mesh)
                       if (t.id % every == 0) std::swap(t.b, t.c);
                     return mesh;
                   },
                   same_ray,
                   [=](const Answered& before, Answered after, bool) {
                     if (after.is_hit() && after.id() % every == 0) std::swap(after.hit.u, after.hit.v);
                     return same_up_to_rounding(test, before, after);
                   }});
    }
  }
}

/// With the triangles in another order a hit keeps the bits of t, u and v and its triangle. Of triangles met at the
/// same t the first in the order is given.
void shuffled_triangles(Exam& exam) {
  if (may_lose_hits(exam)) return;
  for (const Shape& shape : shapes()) {
    holds_after(exam, shape,
                {"shuffled",
                 [](Mesh mesh) {
                   Random random(31);
                   for (u32 i = static_cast<u32>(mesh.size()); i > 1; --i)
                     std::swap(mesh[i - 1], mesh[random.below(i)]);
                   return mesh;
                 },
                 same_ray,
                 [](const Answered& before, const Answered& after, bool) {
                   if (before.id() == after.id()) return same_numbers(before.hit, after.hit);
                   const auto now = std::ranges::find(after.mesh, before.id(), &Corners::id);
                   return before.hit.t == after.hit.t && before.id() < after.id() &&
                          after.mesh.begin() + after.hit.id < now;
                 }});
  }
}

/// Moved by a vector, where no coordinate is rounded by it, nothing changes by a bit.
void translated(Exam& exam) {
  if (may_lose_hits(exam)) return;
  if (intersector_of(exam.technique()) == "baldwin-weber")
    return exam.does_not_apply("its coefficients lose digits with the distance from the origin");
  const auto on_grid = [](Vec3 p) {
    return Vec3{std::nearbyint(p.x * 0x1p12f), std::nearbyint(p.y * 0x1p12f), std::nearbyint(p.z * 0x1p12f)} * 0x1p-12f;
  };
  for (const Shape& shape : shapes()) {
    const Shape& gridded = exam.store().get(shape.name + " on a grid", [&] {
      Shape same{shape.name + " on a grid ", each_vertex(on_grid)(shape.mesh), shape.rays, shape.sealed};
      for (Ray& ray : same.rays) ray.o = on_grid(ray.o);
      return same;
    });
    for (const Vec3 by : {Vec3{3, -1, 2}, Vec3{-1000, 511, 64}}) {
      holds_after(exam, gridded,
                  {"moved by " + text_of(by.x), each_vertex([by](Vec3 p) { return p + by; }),
                   [by](Ray ray) {
                     ray.o = ray.o + by;
                     return ray;
                   },
                   [](const Answered& before, const Answered& after, bool) {
                     return before.id() == after.id() && same_bits(before.hit, after.hit);
                   }});
    }
  }
}

/// Triangles behind all others change no bit of a hit; rays that met nothing meet the sealed surface among them.
void far_geometry(Exam& exam) {
  if (may_lose_hits(exam)) return;
  for (const Shape& shape : shapes()) {
    holds_after(exam, shape,
                {"in a far shell",
                 [](Mesh mesh) {
                   Mesh far = icosphere(2, 50.0f);
                   append(far, icosphere(1, 1e4f));
                   for (Corners& t : far) {
                     t.id = static_cast<u32>(mesh.size());
                     mesh.push_back(t);
                   }
                   return mesh;
                 },
                 same_ray,
                 [](const Answered& before, const Answered& after, bool) {
                   if (before.is_hit()) return same_bits(before.hit, after.hit);
                   return after.is_hit() && after.hit.id >= before.mesh.size();
                 }});
  }
}

}  // namespace raywalk::accuracy
