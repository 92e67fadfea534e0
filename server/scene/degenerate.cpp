// The normal's components, in double where that is enough to tell them from zero, else in four times the precision.
#include "server/scene/degenerate.h"

#include <algorithm>
#include <cmath>

#include "kernels/triangle/double3.h"

namespace raywalk {
namespace {

// Differences, products and the difference of these err by less than 2^-50 of the larger product together.
constexpr double kCertain = 0x1p-49;

bool certainly_differ(double p, double q) {
  return std::abs(p - q) > kCertain * std::max(std::abs(p), std::abs(q));
}

bool same_products(float a0, float a1, float b0, float b1, float c0, float c1) {
  using Wide = __float128;
  const Wide p = (Wide{b0} - Wide{a0}) * (Wide{c1} - Wide{a1}), q = (Wide{b1} - Wide{a1}) * (Wide{c0} - Wide{a0});
  return p == q;
}

}  // namespace

bool is_degenerate(const Corners& triangle) {
  const Vec3 a = triangle.a, b = triangle.b, c = triangle.c;
  const Double3 ab = between(a, b), ac = between(a, c);
  if (certainly_differ(ab.x * ac.y, ab.y * ac.x) || certainly_differ(ab.y * ac.z, ab.z * ac.y) ||
      certainly_differ(ab.z * ac.x, ab.x * ac.z)) {
    return false;
  }
  return same_products(a.x, a.y, b.x, b.y, c.x, c.y) && same_products(a.y, a.z, b.y, b.z, c.y, c.z) &&
         same_products(a.z, a.x, b.z, b.x, c.z, c.x);
}

}  // namespace raywalk
