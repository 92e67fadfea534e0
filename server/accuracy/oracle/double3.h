// Three doubles, and what is known of their rounding. No product of six floats leaves the range of doubles.
#pragma once
#include <algorithm>
#include <cmath>

#include "kernels/vec.h"

namespace raywalk::oracle {

struct Double3 {
  double x, y, z;
  double operator[](u32 axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline Double3 to_double(Vec3 a) {
  return {a.x, a.y, a.z};
}
/// a - b, each component rounded once.
inline Double3 between(Vec3 b, Vec3 a) {
  return {double{a.x} - double{b.x}, double{a.y} - double{b.y}, double{a.z} - double{b.z}};
}
inline Double3 operator+(Double3 a, Double3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Double3 operator-(Double3 a, Double3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Double3 operator*(Double3 a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline double dot(Double3 a, Double3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Double3 cross(Double3 a, Double3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Double3 magnitude(Double3 a) {
  return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}
inline double largest(Double3 a) {
  return std::max({a.x, a.y, a.z});
}
inline double length(Double3 a) {
  return std::sqrt(dot(a, a));
}

/// A value and a bound of its error.
struct Bounded {
  double value, error;
  bool has_sign() const { return std::abs(value) > error || error == 0.0; }
  int sign() const { return (value > 0.0) - (value < 0.0); }
};

/// a . (b x c), where each component has been rounded at most once: then every product of the sum is rounded seven
/// times, and the bound has room for sixteen.
inline Bounded determinant(Double3 a, Double3 b, Double3 c) {
  const Double3 m = magnitude(a), p = magnitude(b), q = magnitude(c);
  const double sum = m.x * (p.y * q.z + p.z * q.y) + m.y * (p.z * q.x + p.x * q.z) + m.z * (p.x * q.y + p.y * q.x);
  return {dot(a, cross(b, c)), 0x1p-49 * sum};
}

}  // namespace raywalk::oracle
