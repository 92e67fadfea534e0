// sRGB transfer (IEC 61966-2-1).
#include "server/image/srgb.h"

#include <array>
#include <cmath>

namespace raywalk {
namespace {

constexpr u32 kSteps = 65535;  // in the steepest part one step is a twentieth of a level

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
  for (const float value : linear)
    *bytes++ = table[static_cast<u32>(clamped(value) * static_cast<float>(kSteps) + 0.5f)];
}

}  // namespace raywalk
