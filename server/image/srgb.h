// The sRGB transfer function, exact and as a table for 8-bit images.
#pragma once
#include <span>

#include "kernels/platform.h"

namespace raywalk {

/// Linear [0, 1] to encoded [0, 1]; values outside are clamped, NaN becomes 0.
float srgb_encoded(float linear);

/// bytes[i] = round(255 * srgb_encoded(linear[i])), by a table: off by one level at most where the exact value is half
/// way between two.
void srgb_bytes(std::span<const float> linear, u8* bytes);

}  // namespace raywalk
