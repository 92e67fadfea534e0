// The sRGB transfer function, exact and as a table for 8-bit images.
#pragma once
#include "kernels/platform.h"

namespace raywalk {

/// Linear [0, 1] to encoded [0, 1]; values outside are clamped, NaN becomes 0.
float srgb_encoded(float linear);

/// round(255 * srgb_encoded(linear)); a table, at most one level away from rounding half-way cases.
u8 srgb_byte(float linear);

}  // namespace raywalk
