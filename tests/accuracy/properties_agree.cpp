// Compares answers within the rounding that a strict test promises.
#include "tests/accuracy/properties_agree.h"

#include <algorithm>
#include <cmath>

#include "kernels/triangle/watertight.h"
#include "server/accuracy/oracle/exact.h"

namespace raywalk::accuracy {
namespace {

/// Twice what rounding may move a hit's t by: the watertight test's errs by 9 u (the largest component of a vertex seen
/// from the origin, in lengths of d), see kernels/accel/padded_frame.h; the exact test's is rounded once.
double allowance(std::string_view intersector, const Answered& answer) {
  const Corners& t = answer.triangle();
  const float reach = std::max({largest(magnitude(t.a - answer.ray.o)), largest(magnitude(t.b - answer.ray.o)),
                                largest(magnitude(t.c - answer.ray.o))});
  const double lengths = double{reach} / double{largest(magnitude(answer.ray.d))};
  return intersector == "exact" ? oracle::ulp_at(answer.hit.t) + 0x1p-29 * lengths : 18 * 0x1p-24 * lengths;
}

bool close_by(std::string_view intersector, const Answered& before, const Answered& after) {
  const double allowed = std::max(allowance(intersector, before), allowance(intersector, after));
  return std::abs(double{before.hit.t} - double{after.hit.t}) <= allowed;
}

/// Whether the hit lies on an edge or a vertex of its triangle, in the arithmetic of a strict test.
bool on_border(std::string_view intersector, const Answered& answer) {
  const Corners& t = answer.triangle();
  if (intersector == "exact") return oracle::classify(answer.ray, t).position != oracle::Position::inside;
  float at, u, v;  // v weighs a
  return answer.hit.u == 0.0f || answer.hit.v == 0.0f ||
         (intersect(Watertight(answer.ray), triangle(t.b, t.c, t.a), at, u, v) && v == 0.0f);
}

bool touch(const Corners& a, const Corners& b) {
  return std::ranges::any_of(std::initializer_list<Vec3>{a.a, a.b, a.c},
                             [&](Vec3 p) { return p == b.a || p == b.b || p == b.c; });
}

}  // namespace

bool same_numbers(const Hit& a, const Hit& b) {
  return a.t == b.t && a.u == b.u && a.v == b.v;
}

u32 main_axis(Vec3 d) {
  const Vec3 m = magnitude(d);
  return m.x > m.y ? (m.x > m.z ? 0u : 2u) : (m.y > m.z ? 1u : 2u);
}

bool same_up_to_rounding(std::string_view intersector, const Answered& before, const Answered& after) {
  constexpr float kWeights = 0x1p-20f;
  if (before.id() != after.id()) return false;
  if (!before.is_hit()) return true;
  return close_by(intersector, before, after) && std::abs(before.hit.u - after.hit.u) <= kWeights &&
         std::abs(before.hit.v - after.hit.v) <= kWeights;
}

bool new_owner(std::string_view intersector, const Answered& before, const Answered& after, bool sealed) {
  if (!before.is_hit() && !after.is_hit()) return false;
  const bool after_first = !before.is_hit() || (after.is_hit() && after.hit.t < before.hit.t);
  if (!on_border(intersector, after_first ? after : before)) return false;
  if (!sealed) return true;
  return close_by(intersector, before, after) && touch(before.mesh[before.hit.id], before.mesh[after.id()]);
}

}  // namespace raywalk::accuracy
