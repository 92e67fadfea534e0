// A small image and the decoding of sRGB, for scenes with textures.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "kernels/platform.h"

namespace raywalk::test {

constexpr u32 texel(u32 red, u32 green, u32 blue) {
  return red | green << 8 | blue << 16;
}

constexpr u32 kPaperWidth = 3, kPaperHeight = 2;
constexpr std::array<u32, kPaperWidth* kPaperHeight> kPaper = {texel(255, 200, 10),  texel(20, 240, 90),
                                                               texel(128, 0, 255),   texel(70, 70, 70),
                                                               texel(255, 255, 255), texel(3, 130, 220)};

/// The linear value of an eight-bit sRGB component (IEC 61966-2-1).
inline double srgb_decoded(u32 component) {
  const double c = component / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
/// SceneHeader::decoding.
inline std::array<float, 256> srgb_decoding() {
  std::array<float, 256> table;
  for (u32 i = 0; i < 256; ++i) table[i] = static_cast<float>(srgb_decoded(i));
  return table;
}

}  // namespace raywalk::test
