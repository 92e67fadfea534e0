// Host only: rounds planes outward. What counts is the float that a node gives after decoding: it is compared here.
#include "kernels/accel/bvh/compress.h"

#include <immintrin.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raywalk::bvh {
namespace {

constexpr u32 kHalfSign = 0x8000u;

float from_half(u32 half, float unit) {
  return _cvtsh_ss(static_cast<unsigned short>(half)) * unit;
}

/// The largest half whose value in units is at most `plane`.
u32 half_below(float plane, float unit) {
  u32 half = _cvtss_sh(plane * (1.0f / unit), _MM_FROUND_TO_NEG_INF);
  // Only a plane that is tiny against the unit has been rounded by the product.
  while (from_half(half, unit) > plane)
    half = half == 0 ? kHalfSign | 1u : (half & kHalfSign) != 0 ? half + 1 : half - 1;
  return half;
}
u32 half_above(float plane, float unit) {
  return half_below(-plane, unit) ^ kHalfSign;
}

/// The origin at or below `low` whose lowest byte is `exponent`, never denormal.
u32 origin_below(float low, u32 exponent) {
  constexpr u32 kSign = 0x80000000u, kSmallest = 0x00800000u;
  u32 bits = (bits_of(low) & ~255u) | exponent;
  if (float_of(bits) > low) bits = (bits & kSign) != 0 ? bits + 256u : bits - 256u;
  // A wrapped difference and a denormal number both become the negative number next to zero.
  return (bits & ~kSign) < kSmallest || (bits_of(low) & ~kSign) < kSmallest ? kSign | kSmallest | exponent : bits;
}

/// One axis of a byte node.
struct Axis {
  u32 origin;

  float at(u32 steps) const {
    return std::fma(static_cast<float>(steps), float_of((origin & 255u) << 23), float_of(origin));
  }
  u32 below(float plane) const {
    u32 steps = estimate(plane);
    while (at(steps) > plane) --steps;
    return steps;
  }
  u32 above(float plane) const {
    u32 steps = estimate(plane);
    while (at(steps) < plane) ++steps;
    return steps;
  }

 private:
  u32 estimate(float plane) const {
    const double step = float_of((origin & 255u) << 23);
    return static_cast<u32>(std::clamp((double{plane} - double{float_of(origin)}) / step, 0.0, 255.0));
  }
};

/// With the finest steps of which 255 reach from `low` to `high`.
Axis axis_of(float low, float high) {
  const double extent = (double{high} - double{low}) / 255.0;
  const int least = extent > 0x1p-126 ? std::ilogb(extent) + 127 : 1;
  for (u32 exponent = static_cast<u32>(least); exponent < 255u; ++exponent) {
    const Axis axis{origin_below(low, exponent)};
    if (!is_finite(float_of(axis.origin))) break;
    if (axis.at(255) >= high) return axis;
  }
  throw std::invalid_argument("bvh: nodes=byte cannot hold coordinates above 3.4e38");
}

}  // namespace

float unit_of_halves(float half_extent) {
  const i32 exponent = static_cast<i32>(bits_of(half_extent) >> 23) - 14;
  return float_of(static_cast<u32>(std::max(exponent, 1)) << 23);
}

HalfNode compressed_to_halves(const Node& node, float unit) {
  HalfNode half{};
  for (u32 axis = 0; axis < 3; ++axis) {
    const Float4 row = node.planes[axis];
    half.planes[axis] = {half_below(row[0], unit) | half_below(row[1], unit) << 16,
                         half_above(row[2], unit) | half_above(row[3], unit) << 16};
  }
  std::copy_n(node.child, 2, half.child);
  return half;
}

ByteNode compressed_to_bytes(const Node& node) {
  ByteNode bytes{};
  for (u32 i = 0; i < 3; ++i) {
    const Float4 row = node.planes[i];
    const Axis axis = axis_of(std::min(row[0], row[1]), std::max(row[2], row[3]));
    bytes.origin[i] = axis.origin;
    bytes.planes[i] =
        axis.below(row[0]) | axis.below(row[1]) << 8 | axis.above(row[2]) << 16 | axis.above(row[3]) << 24;
  }
  std::copy_n(node.child, 2, bytes.child);
  return bytes;
}

void compress(std::span<const Node> nodes, float unit, std::span<HalfNode> to) {
  tbb::parallel_for(size_t{0}, to.size(), [&](size_t i) { to[i] = compressed_to_halves(nodes[i], unit); });
}
void compress(std::span<const Node> nodes, std::span<ByteNode> to) {
  tbb::parallel_for(size_t{0}, to.size(), [&](size_t i) { to[i] = compressed_to_bytes(nodes[i]); });
}

}  // namespace raywalk::bvh
