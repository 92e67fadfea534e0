// Three doubles, for what is done in double precision. Neither products nor sums are fused. No product of six floats
// leaves the range of doubles.
#pragma once
#include "kernels/vec.h"

namespace raywalk {

struct Double3 {
  double x, y, z;
  RW_FN double operator[](u32 axis) const {
    if constexpr (kReadsByAddress) return (&x)[axis];
    return axis == 0 ? x : axis == 1 ? y : z;
  }
};

RW_FN Double3 to_double(Vec3 a) {
  return {a.x, a.y, a.z};
}
/// to - from, each component rounded once.
RW_FN Double3 between(Vec3 from, Vec3 to) {
  return {double{to.x} - double{from.x}, double{to.y} - double{from.y}, double{to.z} - double{from.z}};
}
RW_FN Double3 magnitude(Double3 a) {
  return {magnitude(a.x), magnitude(a.y), magnitude(a.z)};
}
RW_FN double largest(Double3 a) {
  return larger(a.x, larger(a.y, a.z));
}
RW_FN double dot(Double3 a, Double3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
RW_FN Double3 cross(Double3 a, Double3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace raywalk
