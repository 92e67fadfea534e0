// Three floats and the few operations that traversal and shading need.
#pragma once
#include "kernels/platform.h"

namespace raywalk {

struct Vec3 {
  float x, y, z;
  RW_FN float operator[](u32 axis) const {
    if constexpr (kReadsByAddress) return (&x)[axis];
    return axis == 0 ? x : axis == 1 ? y : z;
  }
};

RW_FN Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
RW_FN Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
RW_FN Vec3 operator*(Vec3 a, Vec3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
RW_FN Vec3 operator*(Vec3 a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
RW_FN Vec3 operator*(float s, Vec3 a) {
  return a * s;
}
RW_FN Vec3 operator-(Vec3 a) {
  return {-a.x, -a.y, -a.z};
}
RW_FN bool operator==(Vec3 a, Vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// s * a + b, one rounding a component.
RW_FN Vec3 fma(float s, Vec3 a, Vec3 b) {
  return {fma(s, a.x, b.x), fma(s, a.y, b.y), fma(s, a.z, b.z)};
}
RW_FN float dot(Vec3 a, Vec3 b) {
  return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}
RW_FN Vec3 smaller(Vec3 a, Vec3 b) {
  return {smaller(a.x, b.x), smaller(a.y, b.y), smaller(a.z, b.z)};
}
RW_FN Vec3 larger(Vec3 a, Vec3 b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z)};
}
RW_FN Vec3 magnitude(Vec3 a) {
  return {magnitude(a.x), magnitude(a.y), magnitude(a.z)};
}
RW_FN float largest(Vec3 a) {
  return larger(a.x, larger(a.y, a.z));
}
RW_FN bool is_finite(Vec3 a) {
  return is_finite(a.x) && is_finite(a.y) && is_finite(a.z);
}

/// |a|, at least `floor`, with the sign of a.
RW_FN float away_from_zero(float a, float floor) {
  return with_sign_of(larger(magnitude(a), floor), a);
}
RW_FN Vec3 away_from_zero(Vec3 a, float floor) {
  return {away_from_zero(a.x, floor), away_from_zero(a.y, floor), away_from_zero(a.z, floor)};
}

/// a*b - c*d with an error of at most 1.5 ulp and therefore the exact sign, barring underflow (Kahan's difference of
/// products).
RW_FN float difference_of_products(float a, float b, float c, float d) {
  const float cd = c * d;
  const float error = fma(-c, d, cd);
  return fma(a, b, -cd) + error;
}

RW_FN Vec3 cross(Vec3 a, Vec3 b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

RW_FN float length(Vec3 a) {
  return square_root(dot(a, a));
}
/// A power of two that brings a, which is not negative, near 1; exact to multiply with.
RW_FN float scale_of(float a) {
  return float_of((254u << 23) - smaller(bits_of(a) & 0x7f800000u, 253u << 23));
}
/// Of any length, since it is scaled first; the zero vector stays zero.
RW_FN Vec3 normalized(Vec3 a) {
  const Vec3 scaled = a * scale_of(largest(magnitude(a)));
  const float l = length(scaled);
  return l > 0.0f ? scaled * reciprocal(l) : a;
}

/// Axis-aligned box; empty when lo > hi.
struct Box {
  Vec3 lo{kMaxFloat, kMaxFloat, kMaxFloat};
  Vec3 hi{-kMaxFloat, -kMaxFloat, -kMaxFloat};
  RW_FN void add(Vec3 p) {
    lo = smaller(p, lo);
    hi = larger(p, hi);
  }
  RW_FN void add(const Box& b) {
    lo = smaller(b.lo, lo);
    hi = larger(b.hi, hi);
  }
  RW_FN bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
  RW_FN Vec3 centre() const { return 0.5f * lo + 0.5f * hi; }
  RW_FN Vec3 extent() const { return hi - lo; }
  /// Surface area; 0 when empty.
  RW_FN float area() const {
    if (empty()) return 0.0f;
    const Vec3 e = extent();
    return 2.0f * (e.x * e.y + e.y * e.z + e.z * e.x);
  }
};

}  // namespace raywalk
