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
RW_FN Float4 fma(Float4 a, Float4 b, Float4 c) {
  return {fma(a.x, b.x, c.x), fma(a.y, b.y, c.y), fma(a.z, b.z, c.z), fma(a.w, b.w, c.w)};
}
RW_FN Float4 all_of(float a) {
  return {a, a, a, a};
}
RW_FN Float4 operator*(Float4 a, Float4 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w};
}
/// Two numbers of IEEE's half precision in a word, the lower half first.
RW_FN Float4 floats_of_halves(u32 xy, u32 zw) {
  const auto one = [](u32 bits) {
    float value;
    asm("cvt.f32.f16 %0, %1;" : "=f"(value) : "h"(static_cast<unsigned short>(bits)));
    return value;
  };
  return {one(xy), one(xy >> 16), one(zw), one(zw >> 16)};
}
/// The four bytes of a word, the lowest first.
RW_FN Float4 floats_of_bytes(u32 bytes) {
  // A byte below the bits of 2^23 is that number more.
  const auto one = [bytes](u32 choice) { return float_of(__byte_perm(bytes, 0x4b000000u, choice)) - 0x1p23f; };
  return {one(0x7440u), one(0x7441u), one(0x7442u), one(0x7443u)};
}

#else

using Float4 = float __attribute__((vector_size(16)));
/// Whether the halves, lanes 0 and 1 and lanes 2 and 3, change places.
using HalfSwap = int __attribute__((vector_size(16)));

/// They do when that lane of `v` is below zero.
template <int lane>
inline HalfSwap half_swap(Float4 v) {
  const HalfSwap below = v < 0.0f;
  return (__builtin_shuffle(below, HalfSwap{lane, lane, lane, lane}) & 2) ^ HalfSwap { 0, 1, 2, 3 };
}
inline Float4 swapped(Float4 v, HalfSwap swap) {
  return __builtin_shuffle(v, swap);
}
/// That lane of `a` twice, then that of `b` twice.
template <int lane>
inline Float4 pair_of(Float4 a, Float4 b) {
  return _mm_shuffle_ps(a, b, lane * 0x55);
}
inline Float4 fma(Float4 a, Float4 b, Float4 c) {
  return _mm_fmadd_ps(a, b, c);
}
/// As `larger` of floats: a NaN in `a` is dropped.
inline Float4 larger(Float4 a, Float4 b) {
  return _mm_max_ps(a, b);
}
inline Float4 all_of(float a) {
  return _mm_set1_ps(a);
}
inline Float4 reciprocal(Float4 a) {
  return 1.0f / a;
}
inline Float4 magnitude(Float4 a) {
  return _mm_andnot_ps(all_of(-0.0f), a);
}
/// `a` is not negative.
inline Float4 with_sign_of(Float4 a, Float4 sign) {
  return _mm_or_ps(a, _mm_and_ps(all_of(-0.0f), sign));
}
/// Two numbers of IEEE's half precision in a word, the lower half first.
inline Float4 floats_of_halves(u32 xy, u32 zw) {
  return _mm_cvtph_ps(_mm_cvtsi64_si128(static_cast<long long>(xy | static_cast<u64>(zw) << 32)));
}
inline Float4 floats_of_bytes(u32 bytes) {
  return _mm_cvtepi32_ps(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(static_cast<int>(bytes))));
}
/// Bit i (of two) is set when v[i] <= -v[i + 2].
inline u32 ordered_pairs(Float4 v) {
  const Float4 negated = -__builtin_shuffle(v, HalfSwap{2, 3, 0, 1});
  return static_cast<u32>(_mm_movemask_ps(_mm_cmple_ps(v, negated))) & 3u;
}

#endif

/// `a` in every lane; T is Float4 or float.
template <class T>
RW_FN T splat(float a) {
  return all_of(a);
}
template <>
RW_FN float splat<float>(float a) {
  return a;
}

}  // namespace raywalk
