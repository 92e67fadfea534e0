// Sine, cosine and random numbers with the same bits on every machine: only operations that IEEE 754 rounds exactly.
#pragma once
#include <cmath>

#include "kernels/vec.h"

namespace raywalk {

constexpr double kTau = 6.283185307179586476925;

/// Of a full turn: sine_turns(0.25) = 1. Error below 1e-9.
inline double sine_turns(double turns) {
  turns -= std::floor(turns + 0.5);
  if (turns > 0.25) turns = 0.5 - turns;
  if (turns < -0.25) turns = -0.5 - turns;
  const double x = turns * kTau;
  const double x2 = x * x;
  double sum = 1.0;
  for (int k = 15; k >= 3; k -= 2) sum = 1.0 - sum * x2 / (k * (k - 1));
  return x * sum;
}
inline double cosine_turns(double turns) {
  return sine_turns(turns + 0.25);
}

/// A well-mixed 32-bit hash of a 32-bit number.
inline u32 hashed(u32 x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

/// A small generator: a counter under a hash.
class Random {
 public:
  explicit Random(u32 seed) : state_(hashed(seed + 0x9e3779b9u)) {}
  u32 bits() { return hashed(state_ += 0x9e3779b9u); }
  /// In [0, 1).
  float unit() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }
  float between(float lo, float hi) { return lo + (hi - lo) * unit(); }
  /// In 0 .. n - 1.
  u32 below(u32 n) { return static_cast<u32>(static_cast<u64>(bits()) * n >> 32); }

 private:
  u32 state_;
};

}  // namespace raywalk
