// Exact determinants by GMP.
#include "server/accuracy/oracle/integers.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace raywalk::oracle {
namespace {

constexpr long kLowestBit = -149;  // of a denormal float
constexpr long kMantissaBits = 24;

/// a = mantissa * 2^exponent.
struct Parts {
  long mantissa, exponent;
};

Parts parts_of(float a) {
  const u32 bits = bits_of(a);
  const long field = (bits >> 23) & 0xff, fraction = bits & 0x7fffff;
  const long mantissa = field == 0 ? fraction : fraction | 0x800000;
  return {(bits >> 31) != 0 ? -mantissa : mantissa, field == 0 ? kLowestBit : field - 127 - 23};
}

/// The exponent of the unit in which all of `values` are integers.
long common_exponent(std::span<const float> values) {
  long lowest = 128;
  for (const float a : values) {
    const Parts parts = parts_of(a);
    if (parts.mantissa != 0) lowest = std::min(lowest, parts.exponent);
  }
  return lowest;
}

mpz_class scaled(float a, long exponent) {
  const Parts parts = parts_of(a);
  mpz_class result(parts.mantissa);
  if (parts.mantissa != 0) result <<= static_cast<mp_bitcnt_t>(parts.exponent - exponent);
  return result;
}

mpz_class determinant(const mpz_class (&a)[3], const mpz_class (&b)[3], const mpz_class (&c)[3]) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

long bits_in(const mpz_class& a) {
  return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2));
}

/// a * 2^shift, toward zero when the shift is to the right.
mpz_class shifted(const mpz_class& a, long shift) {
  mpz_class result(a);
  if (shift > 0) result <<= static_cast<mp_bitcnt_t>(shift);
  if (shift < 0) mpz_tdiv_q_2exp(result.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
  return result;
}

}  // namespace

Integers::Integers(const Ray& ray, const Corners& triangle)
    : direction_exponent_(common_exponent(std::span(&ray.d.x, 3))) {
  const Vec3 points[4] = {triangle.a, triangle.b, triangle.c, ray.o};
  corner_exponent_ = common_exponent(std::span(&points[0].x, 12));
  for (u32 axis = 0; axis < 3; ++axis) {
    direction_[axis] = scaled(ray.d[axis], direction_exponent_);
    const mpz_class origin = scaled(ray.o[axis], corner_exponent_);
    for (u32 i = 0; i < 3; ++i) corner_[i][axis] = scaled(points[i][axis], corner_exponent_) - origin;
  }
}

int Integers::edge_sign(u32 opposite) const {
  return sgn(determinant(direction_, corner_[(opposite + 1) % 3], corner_[(opposite + 2) % 3]));
}

void Integers::normal(Vector& n) const {
  for (u32 axis = 0; axis < 3; ++axis) {
    const u32 y = (axis + 1) % 3, z = (axis + 2) % 3;
    n[axis] = (corner_[1][y] - corner_[0][y]) * (corner_[2][z] - corner_[0][z]) -
              (corner_[1][z] - corner_[0][z]) * (corner_[2][y] - corner_[0][y]);
  }
}

bool Integers::is_degenerate() const {
  Vector n;
  normal(n);
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

Ratio Integers::distance() const {
  Vector n;
  normal(n);
  Ratio result{corner_[0][0] * n[0] + corner_[0][1] * n[1] + corner_[0][2] * n[2],
               direction_[0] * n[0] + direction_[1] * n[1] + direction_[2] * n[2],
               corner_exponent_ - direction_exponent_};
  if (result.denominator < 0) {
    result.denominator = -result.denominator;
    result.numerator = -result.numerator;
  }
  return result;
}

float to_float(const Ratio& ratio) {
  if (ratio.numerator == 0) return 0.0f;
  const mpz_class size = abs(ratio.numerator);
  // The leading bit of the quotient is this one or the next lower one.
  const long leading = bits_in(size) - bits_in(ratio.denominator) + ratio.exponent;
  long unit = std::max(leading - kMantissaBits, kLowestBit);
  mpz_class quotient, rest, dividend, divisor;
  const auto divide_by_unit = [&] {
    const long shift = ratio.exponent - unit;
    dividend = shifted(size, std::max(shift, 0L));
    divisor = shifted(ratio.denominator, std::max(-shift, 0L));
    mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());
  };
  divide_by_unit();
  if (bits_in(quotient) > kMantissaBits) {
    ++unit;
    divide_by_unit();
  }
  const int half = cmp(mpz_class(2 * rest), divisor);
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()))) ++quotient;
  const auto result = static_cast<float>(std::ldexp(quotient.get_d(), static_cast<int>(unit)));
  return ratio.numerator < 0 ? -result : result;
}

double to_double(const Ratio& ratio) {
  if (ratio.numerator == 0) return 0.0;
  const long shift = 64 + bits_in(ratio.denominator) - bits_in(ratio.numerator);
  const mpz_class quotient = shift > 0 ? mpz_class(shifted(ratio.numerator, shift) / ratio.denominator)
                                       : mpz_class(ratio.numerator / shifted(ratio.denominator, -shift));
  return std::ldexp(quotient.get_d(), static_cast<int>(ratio.exponent - shift));
}

int compare(const Ratio& a, const Ratio& b) {
  const long lowest = std::min(a.exponent, b.exponent);
  const mpz_class left = shifted(a.numerator * b.denominator, a.exponent - lowest);
  const mpz_class right = shifted(b.numerator * a.denominator, b.exponent - lowest);
  const int order = cmp(left, right);
  return (order > 0) - (order < 0);
}

Ratio to_ratio(float a) {
  const Parts parts = parts_of(a);
  return {parts.mantissa, 1, parts.exponent};
}

}  // namespace raywalk::oracle
