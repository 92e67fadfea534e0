// More of three doubles, and what is known of their rounding.
#pragma once
#include <cmath>

#include "kernels/triangle/double3.h"

namespace raywalk {

inline Double3 operator+(Double3 a, Double3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Double3 operator-(Double3 a, Double3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Double3 operator*(Double3 a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline double length(Double3 a) {
  return std::sqrt(dot(a, a));
}

namespace oracle {

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

}  // namespace oracle
}  // namespace raywalk
