// Sums of doubles without any rounding: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates", Discrete & Computational Geometry 18, 1997.
#pragma once
#include "kernels/platform.h"

namespace raywalk {

namespace detail {

/// Adds x to `count` parts without rounding; returns how many parts there are then.
RW_SLOW_FN u32 add_to_parts(double* part, u32 count, double x) {
  u32 kept = 0;
  for (u32 i = 0; i < count; ++i) {
    // The sum of two, and what its rounding lost.
    const double sum = x + part[i], of_part = sum - x;
    const double lost = (x - (sum - of_part)) + (part[i] - of_part);
    x = sum;
    if (lost != 0.0) part[kept++] = lost;
  }
  if (x != 0.0) part[kept++] = x;
  return kept;
}

}  // namespace detail

/// An exact number as a sum of doubles that do not overlap, ascending; room for kCapacity summands. Right to nearest
/// even, none of them may over- or underflow.
template <u32 kCapacity>
struct ExactSum {
  double part[kCapacity];
  u32 count = 0;

  RW_FN void add(double x) { count = detail::add_to_parts(part, count, x); }
  RW_FN void add_product(double a, double b) {
    const double product = a * b;
    const double lost = fma(a, b, -product);
    if (lost != 0.0) add(lost);
    add(product);
  }
  /// Its sign is exact, its relative error below 2^-49.
  RW_FN double value() const {
    double sum = 0.0;
    for (u32 i = 0; i < count; ++i) sum += part[i];
    return sum;
  }
};

}  // namespace raywalk
