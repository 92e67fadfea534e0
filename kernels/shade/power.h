// x^n from polynomials, so that a highlight is the same on CPU and GPU and the loop around it can be vectorised.
#pragma once
#include "kernels/vec.h"

namespace raywalk {

/// Base-2 logarithm of a positive normal number; relative error below 2e-7.
RW_FN float log2_of(float x) {
  // x = 2^e * m with m in [sqrt(1/2), sqrt(2)); log2 m = 2/ln2 * atanh((m-1)/(m+1)).
  const u32 shifted = bits_of(x) - 0x3f3504f3u;
  const float e = static_cast<float>(static_cast<i32>(shifted) >> 23);
  const float m = float_of((shifted & 0x007fffffu) + 0x3f3504f3u);
  const float s = divide(m - 1.0f, m + 1.0f);
  const float s2 = s * s;
  const float series = fma(s2, fma(s2, fma(s2, fma(s2, 0.11111111f, 0.14285714f), 0.2f), 0.33333333f), 1.0f);
  return fma(2.8853901f * s, series, e);
}

/// 2^x for x in [-126, 126]; relative error below 4e-7.
RW_FN float exp2_of(float x) {
  const float rounder = 12582912.0f;  // 1.5 * 2^23: adding it rounds to a whole number
  const float whole = (x + rounder) - rounder;
  const float f = (x - whole) * 0.69314718f;
  const float series =
      fma(f,
          fma(f, fma(f, fma(f, fma(f, fma(f, 1.9841270e-4f, 1.3888889e-3f), 8.3333333e-3f), 0.041666667f), 0.16666667f),
              0.5f),
          1.0f);
  const float mantissa = fma(f, series, 1.0f);
  return float_of(bits_of(mantissa) + (static_cast<u32>(static_cast<i32>(whole)) << 23));
}

/// x^n for x in [0, 1] and n >= 1, without a branch; x below 1e-30 counts as 1e-30, values under 2^-120 are 0.
RW_FN float power(float x, float n) {
  const float exponent = larger(n * log2_of(larger(x, 1e-30f)), -121.0f);
  const float value = exp2_of(exponent);
  return exponent > -120.0f ? value : 0.0f;
}

}  // namespace raywalk
