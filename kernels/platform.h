// The only file that asks "host or device": qualifiers, fixed-width types and the math both sides share bit for bit.
// RW_FN stands before every function; RW_SLOW_FN before one that is seldom called and stays out of line.
#pragma once

#if defined(__CUDACC__)
#define RW_GPU 1
#define RW_FN __device__ __forceinline__
#define RW_SLOW_FN static __device__ __noinline__
#else
#define RW_GPU 0
#define RW_FN inline __attribute__((always_inline))
#define RW_SLOW_FN inline __attribute__((noinline))
#endif

namespace raywalk {

using u8 = unsigned char;
using u32 = unsigned int;
using i32 = int;
using u64 = unsigned long long;

constexpr float kMaxFloat = 3.402823466e+38f;

/// Whether code is compiled for the features of one scene, or once for all scenes.
constexpr bool kCompiledForScene = RW_GPU != 0;
/// A GPU selects among registers; a CPU reads by address, since it would predict the branches of a selection wrongly.
constexpr bool kReadsByAddress = RW_GPU == 0;

// Contraction is off on both sides; a fused multiply-add happens exactly where it is written.
#if RW_GPU
RW_FN float fma(float a, float b, float c) {
  return __fmaf_rn(a, b, c);
}
RW_FN double fma(double a, double b, double c) {
  return __fma_rn(a, b, c);
}
RW_FN float square_root(float a) {
  return __fsqrt_rn(a);
}
RW_FN float divide(float a, float b) {
  return __fdiv_rn(a, b);
}
/// The same bits as divide(1, a).
RW_FN float reciprocal(float a) {
  return __frcp_rn(a);
}
RW_FN u32 bits_of(float a) {
  return __float_as_uint(a);
}
RW_FN float float_of(u32 a) {
  return __uint_as_float(a);
}
#else
RW_FN float fma(float a, float b, float c) {
  return __builtin_fmaf(a, b, c);
}
RW_FN double fma(double a, double b, double c) {
  return __builtin_fma(a, b, c);
}
RW_FN float square_root(float a) {
  return __builtin_sqrtf(a);
}
RW_FN float divide(float a, float b) {
  return a / b;
}
RW_FN float reciprocal(float a) {
  return 1.0f / a;
}
RW_FN u32 bits_of(float a) {
  return __builtin_bit_cast(u32, a);
}
RW_FN float float_of(u32 a) {
  return __builtin_bit_cast(float, a);
}
#endif

// A NaN in the first argument is dropped: smaller(NaN, b) == b and larger(NaN, b) == b. The sign of a zero is not
// defined when both are zeros.
#if RW_GPU
RW_FN float smaller(float a, float b) {
  return ::fminf(a, b);
}
RW_FN float larger(float a, float b) {
  return ::fmaxf(a, b);
}
RW_FN float magnitude(float a) {
  return float_of(bits_of(a) & 0x7fffffffu);
}
#else
RW_FN float smaller(float a, float b) {
  return a < b ? a : b;
}
RW_FN float larger(float a, float b) {
  return a > b ? a : b;
}
RW_FN float magnitude(float a) {
  return __builtin_fabsf(a);  // stays in its register
}
#endif
RW_FN u32 smaller(u32 a, u32 b) {
  return a < b ? a : b;
}
RW_FN u32 larger(u32 a, u32 b) {
  return a > b ? a : b;
}
/// `a` is not negative.
RW_FN float with_sign_of(float a, float sign) {
  return float_of(bits_of(a) | (bits_of(sign) & 0x80000000u));
}
RW_FN double magnitude(double a) {
  return a < 0.0 ? -a : a;
}
RW_FN double larger(double a, double b) {
  return a > b ? a : b;
}
RW_FN bool is_finite(float a) {
  return (bits_of(a) & 0x7f800000u) != 0x7f800000u;
}

}  // namespace raywalk
