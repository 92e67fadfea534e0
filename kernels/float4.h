// Four floats handled at once: a vector register on the host, four registers on the GPU; the same bits on both.
#pragma once
#include "kernels/platform.h"

#if !RW_GPU
#include <immintrin.h>
#endif

namespace raywalk {

#if RW_GPU

struct alignas(16) Float4 {
  float x, y, z, w;
  RW_FN float operator[](u32 lane) const { return lane == 0 ? x : lane == 1 ? y : lane == 2 ? z : w; }
};
/// Whether the halves (x, y) and (z, w) change places.
struct HalfSwap {
  bool on;
};
RW_FN HalfSwap half_swap(bool on) {
  return {on};
}
RW_FN Float4 swapped(Float4 v, HalfSwap swap) {
  return {swap.on ? v.z : v.x, swap.on ? v.w : v.y, swap.on ? v.x : v.z, swap.on ? v.y : v.w};
}
RW_FN Float4 fma(Float4 a, Float4 b, Float4 c) {
  return {fma(a.x, b.x, c.x), fma(a.y, b.y, c.y), fma(a.z, b.z, c.z), fma(a.w, b.w, c.w)};
}
/// As `larger` of floats: a NaN in `a` is dropped.
RW_FN Float4 larger(Float4 a, Float4 b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z), larger(a.w, b.w)};
}
/// Bit i (of two) is set when v[i] <= -v[i + 2].
RW_FN u32 ordered_pairs(Float4 v) {
  return (v.x <= -v.z ? 1u : 0u) | (v.y <= -v.w ? 2u : 0u);
}

#else

using Float4 = float __attribute__((vector_size(16)));
using HalfSwap = int __attribute__((vector_size(16)));

inline HalfSwap half_swap(bool on) {
  return on ? HalfSwap{2, 3, 0, 1} : HalfSwap{0, 1, 2, 3};
}
inline Float4 swapped(Float4 v, HalfSwap swap) {
  return __builtin_shuffle(v, swap);
}
inline Float4 fma(Float4 a, Float4 b, Float4 c) {
  return _mm_fmadd_ps(a, b, c);
}
inline Float4 larger(Float4 a, Float4 b) {
  return _mm_max_ps(a, b);
}
inline u32 ordered_pairs(Float4 v) {
  const Float4 negated = -__builtin_shuffle(v, HalfSwap{2, 3, 0, 1});
  return static_cast<u32>(_mm_movemask_ps(_mm_cmple_ps(v, negated))) & 3u;
}

#endif

}  // namespace raywalk
