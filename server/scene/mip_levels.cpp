// Halving images in linear light.
#include "server/scene/mip_levels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk {
namespace {

// Means are rounded to this many steps before they are encoded: the darkest sRGB component is 20 of them wide.
constexpr u32 kSteps = 1 << 16;

const std::array<u32, 256>& decoding() {
  static const std::array<u32, 256> table = [] {
    std::array<u32, 256> t{};
    for (u32 i = 0; i < 256; ++i) t[i] = static_cast<u32>(std::lround(linear_of_srgb(i) * (kSteps - 1)));
    return t;
  }();
  return table;
}

/// The sRGB component nearest to a linear value of 0 .. kSteps - 1.
const std::array<u8, kSteps>& encoding() {
  static const std::array<u8, kSteps> table = [] {
    std::array<u8, kSteps> t{};
    u32 component = 0;
    for (u32 i = 0; i < kSteps; ++i) {
      while (component < 255 && 2 * i > decoding()[component] + decoding()[component + 1]) ++component;
      t[i] = static_cast<u8>(component);
    }
    return t;
  }();
  return table;
}

u32 half(u32 side) {
  return std::max(1u, side / 2);
}

Texture halved(const Texture& from) {
  Texture to{from.name, half(from.width), half(from.height), {}};
  to.texels.resize(size_t{to.width} * to.height);
  const u32 right = from.width > 1 ? 1 : 0;
  const size_t below = from.height > 1 ? from.width : 0;
  const std::array<u32, 256>& linear = decoding();
  const std::array<u8, kSteps>& srgb = encoding();
  for (u32 y = 0; y < to.height; ++y) {
    const u32* row = from.texels.data() + size_t{2} * y * from.width;
    for (u32 x = 0; x < to.width; ++x) {
      const u32 texels[4] = {row[2 * x], row[2 * x + right], row[2 * x + below], row[2 * x + below + right]};
      u32 mean = 0;
      for (u32 shift = 0; shift < 24; shift += 8) {
        u32 sum = 2;
        for (const u32 texel : texels) sum += linear[(texel >> shift) & 255u];
        mean |= u32{srgb[sum / 4]} << shift;
      }
      to.texels[size_t{y} * to.width + x] = mean;
    }
  }
  return to;
}

}  // namespace

float linear_of_srgb(u32 component) {
  const double c = component / 255.0;
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

std::vector<Texture> mip_levels(const Texture& texture) {
  std::vector<Texture> levels;
  for (const Texture* last = &texture; last->width > 1 || last->height > 1; last = &levels.back()) {
    levels.push_back(halved(*last));
  }
  return levels;
}

MipCounts mip_counts(u32 width, u32 height) {
  MipCounts counts;
  while (width > 1 || height > 1) {
    width = half(width);
    height = half(height);
    ++counts.levels;
    counts.texels += u64{width} * height;
  }
  return counts;
}

}  // namespace raywalk
