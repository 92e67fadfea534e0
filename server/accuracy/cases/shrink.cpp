// Delta debugging of one ray and a few triangles.
#include "server/accuracy/cases/shrink.h"

#include <algorithm>

namespace raywalk::accuracy {
namespace {

constexpr u32 kMostTries = 600;
constexpr u32 kMantissaBits = 23;

/// Rounded to `bits` bits behind the leading one.
float rounded(float a, u32 bits) {
  const u32 dropped = kMantissaBits - bits;
  const u32 half = dropped == 0 ? 0u : 1u << (dropped - 1);
  return float_of((bits_of(a) + half) & ~((1u << dropped) - 1u));
}

class Shrinker {
 public:
  explicit Shrinker(Failure failure) : now_(std::move(failure)) {}

  Failure run() {
    if (!still_fails(now_)) return std::move(now_);
    drop_triangles();
    simplify_ray();
    simplify_vertices();
    drop_triangles();
    return std::move(now_);
  }

 private:
  Failure now_;
  u32 tries_ = 0;

  bool still_fails(const Failure& candidate) {
    return ++tries_ <= kMostTries && is_valid(candidate.ray) &&
           candidate.still_fails(candidate.ray, candidate.triangles);
  }
  bool take_if_failing(Failure candidate) {
    if (!still_fails(candidate)) return false;
    now_ = std::move(candidate);
    return true;
  }
  void drop_triangles() {
    for (std::size_t i = now_.triangles.size(); i-- > 0 && now_.triangles.size() > 1;) {
      Failure fewer = now_;
      fewer.triangles.erase(fewer.triangles.begin() + static_cast<std::ptrdiff_t>(i));
      take_if_failing(std::move(fewer));
    }
  }
  /// `set(failure, value)` writes the number that is `value` now.
  template <class Set>
  void simplify(float value, Set set) {
    const auto take = [&](float simpler) {
      Failure candidate = now_;
      set(candidate, simpler);
      return take_if_failing(std::move(candidate));
    };
    if (value == 0.0f || !is_finite(value) || take(0.0f)) return;
    for (const u32 bits : {0u, 1u, 2u, 4u, 7u, 11u, 15u, 19u}) {
      if (rounded(value, bits) == value || take(rounded(value, bits))) return;
    }
  }
  void simplify_ray() {
    for (float Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      simplify(now_.ray.o.*component, [&](Failure& f, float value) { f.ray.o.*component = value; });
      simplify(now_.ray.d.*component, [&](Failure& f, float value) { f.ray.d.*component = value; });
    }
  }
  void simplify_vertices() {
    std::vector<Vec3> vertices;
    for (const Corners& t : now_.triangles)
      for (const Vec3 p : {t.a, t.b, t.c})
        if (std::ranges::find(vertices, p) == vertices.end()) vertices.push_back(p);
    for (Vec3 vertex : vertices) {
      for (float Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        Vec3 written = vertex;
        simplify(vertex.*component, [&](Failure& f, float value) {
          written = vertex;
          written.*component = value;
          for (Corners& t : f.triangles)
            for (Vec3* p : {&t.a, &t.b, &t.c})
              if (*p == vertex) *p = written;
        });
        const auto is_there = [&](const Corners& t) { return t.a == written || t.b == written || t.c == written; };
        const auto is_gone = [&](const Corners& t) { return !(t.a == vertex || t.b == vertex || t.c == vertex); };
        if (std::ranges::all_of(now_.triangles, is_gone) && std::ranges::any_of(now_.triangles, is_there))
          vertex = written;
      }
    }
  }
};

}  // namespace

Failure shrunk(Failure failure) {
  if (!failure.still_fails) return failure;
  return Shrinker(std::move(failure)).run();
}

}  // namespace raywalk::accuracy
