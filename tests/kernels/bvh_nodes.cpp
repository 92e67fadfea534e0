// Nodes of lower precision contain the precise ones: a float plus a sum of few bits is compared without any rounding.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/accel/bvh/compress.h"
#include "tests/support/meshes.h"

namespace raywalk::test {
namespace {

using bvh::ByteNode;
using bvh::HalfNode;
using bvh::Node;

/// What a plane of half precision stands for, by its definition: no operation here rounds.
double half_value(u32 half, float unit) {
  const int exponent = static_cast<int>(half >> 10 & 31u), fraction = static_cast<int>(half & 1023u);
  const double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  return (half & 0x8000u ? -size : size) * double{unit};
}

Node random_node(Random& random, float scale, float size) {
  Node node{};
  for (u32 axis = 0; axis < 3; ++axis) {
    float planes[4];
    for (u32 side = 0; side < 2; ++side) {
      const float centre = scale * random.uniform(-1.0f, 1.0f), half = random.below(4) ? size * random.uniform() : 0.0f;
      planes[side] = std::max(centre - half, -scale);
      planes[side + 2] = std::min(std::max(centre + half, planes[side]), scale);
      if (random.below(8) == 0) planes[side] = -scale;
      if (random.below(8) == 0) planes[side + 2] = scale;
      if (random.below(16) == 0) planes[side] = std::min(0.0f, planes[side + 2]);
      if (random.below(16) == 0) planes[side + 2] = std::max(-0.0f, planes[side]);
    }
    node.planes[axis] = Float4{planes[0], planes[1], planes[2], planes[3]};
  }
  node.child[0] = random.below(1000);
  node.child[1] = bvh::leaf(random.below(1000), 1 + random.below(8));
  return node;
}

/// Low planes at or below, high planes at or above, and no farther off than `loose`.
template <class NodeT>
void expect_contains(const NodeT& coarse, const Node& node, float unit, const double (&loose)[3]) {
  for (u32 axis = 0; axis < 3; ++axis) {
    const Float4 row = coarse.row(axis, unit), precise = node.planes[axis];
    for (u32 i = 0; i < 4; ++i) {
      const double outward = (i < 2 ? -1.0 : 1.0) * (double{row[i]} - double{precise[i]});
      ASSERT_GE(outward, 0.0) << row[i] << ' ' << precise[i];
      ASSERT_LE(outward, loose[axis]) << row[i] << ' ' << precise[i];
    }
  }
  ASSERT_EQ(coarse.child[0], node.child[0]);
  ASSERT_EQ(coarse.child[1], node.child[1]);
}

TEST(BvhNodes, CoarseOnesContainPreciseOnes) {
  Random random(1);
  for (const float scale : {1e-44f, 1e-38f, 1e-30f, 1e-6f, 1.0f, 3.7e3f, 1e20f, 1e38f}) {
    for (const float share : {1.0f, 1e-2f, 1e-5f, 1e-9f}) {
      const float unit = bvh::unit_of_halves(scale);
      for (u32 i = 0; i < 2000; ++i) {
        const Node node = random_node(random, scale, share * scale);
        const HalfNode halves = compressed_to_halves(node, unit);
        const ByteNode bytes = compressed_to_bytes(node);
        const double by_halves = 0x1p-10 * double{scale} + 0x1p-24 * double{unit};
        const double half_loose[3] = {by_halves, by_halves, by_halves};
        double byte_loose[3];
        for (u32 axis = 0; axis < 3; ++axis) {
          const Float4 row = node.planes[axis];
          const double low = std::min(row[0], row[1]), high = std::max(row[2], row[3]);
          // A step is at most 4/255 of the extent, or little more than the last digit of the origin.
          byte_loose[axis] = 4.0 / 255 * (high - low) + 0x1p-14 * std::abs(low) + 0x1p-123;
        }
        expect_contains(halves, node, unit, half_loose);
        expect_contains(bytes, node, unit, byte_loose);
        for (u32 axis = 0; axis < 3; ++axis) {
          const u32 words[4] = {halves.planes[axis].low & 0xffffu, halves.planes[axis].low >> 16,
                                halves.planes[axis].high & 0xffffu, halves.planes[axis].high >> 16};
          for (u32 k = 0; k < 4; ++k)
            if (unit > 0x1p-100f) {
              EXPECT_EQ(half_value(words[k], unit), double{halves.row(axis, unit)[k]});
            }
        }
      }
    }
  }
}

TEST(BvhNodes, EveryHalfAndEveryByteDecodesAsDefined) {
  const float unit = 0x1p-3f;
  for (u32 bits = 0; bits < 0x10000u; ++bits) {
    if ((bits & 0x7c00u) == 0x7c00u) continue;  // infinities and NaN are never written
    HalfNode node{};
    node.planes[1] = {bits, bits << 16};
    EXPECT_EQ(double{node.row(1, unit)[0]}, half_value(bits, unit));
    EXPECT_EQ(double{node.row(1, unit)[3]}, half_value(bits, unit));
  }
  ByteNode node{};
  for (u32 byte = 0; byte < 256; ++byte) {
    for (const u32 exponent : {1u, 100u, 127u, 200u}) {
      node.origin[2] = 0xc1200000u | exponent;  // near -10
      node.planes[2] = byte | (255u - byte) << 8 | byte << 16 | 7u << 24;
      const auto expected = [&](u32 steps) {
        const double exact = std::ldexp(steps, static_cast<int>(exponent) - 127) + double{float_of(node.origin[2])};
        return static_cast<float>(
            exact);  // at most 8 and 24 bits: for these exponents the sum is a double or rounds once
      };
      const Float4 row = node.row(2, 0.0f);
      EXPECT_EQ(row[0], expected(byte));
      EXPECT_EQ(row[1], expected(255 - byte));
      EXPECT_EQ(row[2], expected(byte));
      EXPECT_EQ(row[3], expected(7));
    }
  }
}

TEST(BvhNodes, BytesRefuseTheEndOfTheFloats) {
  Node node{};
  for (Float4& row : node.planes) row = Float4{-kMaxFloat, 0, 0, kMaxFloat};
  EXPECT_THROW(compressed_to_bytes(node), std::invalid_argument);
}

}  // namespace
}  // namespace raywalk::test
