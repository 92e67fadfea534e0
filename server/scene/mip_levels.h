// The smaller versions of a texture.
#pragma once
#include <vector>

#include "server/scene/scene.h"

namespace raywalk {

/// The linear value of an eight-bit sRGB component (IEC 61966-2-1).
float linear_of_srgb(u32 component);

/// A texture's versions down to 1 x 1, without itself: each half as wide and high (rounded down, at least 1), each
/// texel the mean of four in linear light.
std::vector<Texture> mip_levels(const Texture& texture);

/// How many mip_levels() gives, and the texels of all of them.
struct MipCounts {
  u32 levels = 0;
  u64 texels = 0;
};
MipCounts mip_counts(u32 width, u32 height);

}  // namespace raywalk
