// The oracle's questions answered by rational numbers alone: slow, plain, without a filter.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "server/accuracy/oracle/exact.h"

namespace raywalk::oracle {

using Rational3 = std::array<mpq_class, 3>;

inline Rational3 rational(Vec3 a) {
  return {mpq_class(a.x), mpq_class(a.y), mpq_class(a.z)};
}
inline Rational3 minus(const Rational3& a, const Rational3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational3 along(const Rational3& a, const Rational3& b, const mpq_class& s) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline mpq_class dot(const Rational3& a, const Rational3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Rational3 cross(const Rational3& a, const Rational3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct RationalCrossing {
  Position position;
  std::optional<mpq_class> t;  // when met
};

/// By barycentric coordinates of the point in the plane.
inline RationalCrossing rational_crossing(const Rational3& o, const Rational3& d, const Corners& triangle) {
  const Rational3 a = rational(triangle.a), b = rational(triangle.b), c = rational(triangle.c);
  const Rational3 n = cross(minus(b, a), minus(c, a));
  const mpq_class slope = dot(n, d), height = dot(n, minus(a, o));
  if (dot(n, n) == 0) {
    // Coplanar when the line and the segment, or point, that remains lie in one plane of any normal.
    const Rational3 p = cross(minus(a, o), d), q = cross(minus(b, o), d), r = cross(minus(c, o), d);
    const bool all = dot(p, minus(b, o)) == 0 && dot(q, minus(c, o)) == 0 && dot(r, minus(a, o)) == 0;
    return {all ? Position::coplanar : Position::outside, {}};
  }
  if (slope == 0) return {height == 0 ? Position::coplanar : Position::outside, {}};
  const mpq_class t = height / slope;
  const Rational3 p = along(o, d, t);
  const mpq_class area = dot(n, n);
  const mpq_class weight[3] = {dot(n, cross(minus(b, p), minus(c, p))) / area,
                               dot(n, cross(minus(c, p), minus(a, p))) / area,
                               dot(n, cross(minus(a, p), minus(b, p))) / area};
  int zeros = 0;
  for (const mpq_class& w : weight) {
    if (w < 0) return {Position::outside, {}};
    zeros += w == 0;
  }
  return {zeros == 0 ? Position::inside : zeros == 1 ? Position::edge : Position::vertex, t};
}

/// The squared distance between the line o + t*d and the segment pq.
inline mpq_class squared_line_distance(const Rational3& o, const Rational3& d, const Rational3& p, const Rational3& q) {
  const mpq_class dd = dot(d, d);
  const auto across = [&](const Rational3& x) {
    const Rational3 seen = minus(x, o);
    return along(seen, d, -dot(seen, d) / dd);
  };
  const Rational3 from = across(p), side = minus(across(q), from);
  const mpq_class squared_length = dot(side, side);
  mpq_class s = 0;
  if (squared_length != 0) s = -dot(from, side) / squared_length;
  s = std::clamp(s, mpq_class(0), mpq_class(1));
  const Rational3 closest = along(from, side, s);
  return dot(closest, closest);
}

/// The nearest float, ties to even, found by trying neighbours.
inline float nearest_float(const mpq_class& t) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const mpq_class overflow = mpq_class(kMaxFloat) + mpq_class(0x1p103);
  if (t >= overflow) return kInfinite;
  if (t <= -overflow) return -kInfinite;
  auto guess = static_cast<float>(t.get_d());
  guess = std::clamp(guess, -kMaxFloat, kMaxFloat);
  float best = guess;
  for (const float other : {std::nextafter(guess, -kInfinite), std::nextafter(guess, kInfinite)}) {
    if (!is_finite(other)) continue;
    const mpq_class error = abs(t - mpq_class(best)), other_error = abs(t - mpq_class(other));
    if (other_error < error || (other_error == error && bits_of(other) % 2 == 0)) best = other;
  }
  return best;
}

}  // namespace raywalk::oracle
