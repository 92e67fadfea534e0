// sRGB transfer (IEC 61966-2-1).
#include "server/image/srgb.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk {
namespace {

constexpr u32 kSteps =
    16383;  // the table stays in the first cache; in the steepest part one step is a fifth of a level

float clamped(float x) {
  return smaller(larger(x, 0.0f), 1.0f);
}

std::array<u8, kSteps + 1> make_table() {
  std::array<u8, kSteps + 1> table;
  for (u32 i = 0; i <= kSteps; ++i) {
    table[i] = static_cast<u8>(std::lround(255.0f * srgb_encoded(static_cast<float>(i) / static_cast<float>(kSteps))));
  }
  return table;
}

}  // namespace

float srgb_encoded(float linear) {  // written so that 1 becomes 1 exactly
  const float x = clamped(linear);
  return x <= 0.0031308f ? 12.92f * x : 1.0f - 1.055f * (1.0f - std::pow(x, 1.0f / 2.4f));
}

void srgb_bytes(std::span<const float> linear, u8* bytes) {
  static const std::array<u8, kSteps + 1> table = make_table();
  constexpr std::size_t kGrain = 65536;
  const tbb::blocked_range<std::size_t> all(0, linear.size(), kGrain);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    // Two loops over a block: the first is vectorised, the second is loads alone.
    constexpr std::size_t kBlock = 512;
    std::array<int, kBlock> index;
    for (std::size_t begin = range.begin(); begin < range.end(); begin += kBlock) {
      const std::size_t count = std::min(kBlock, range.end() - begin);
      for (std::size_t i = 0; i < count; ++i) {
        index[i] = static_cast<int>(clamped(linear[begin + i]) * static_cast<float>(kSteps) + 0.5f);
      }
      for (std::size_t i = 0; i < count; ++i) bytes[begin + i] = table[static_cast<std::size_t>(index[i])];
    }
  });
}

}  // namespace raywalk
