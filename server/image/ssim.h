// Structural similarity of two pictures.
#pragma once
#include <span>

#include "kernels/platform.h"

namespace raywalk {

constexpr u32 kSsimReach = 5;  // rows and columns that a pixel is compared with, on either side

/// SSIM after Wang, Bovik, Sheikh and Simoncelli (2004): mean over all pixels of `luma` (values in 0..1, rows top
/// down), with their 11 x 11 Gaussian of sigma 1.5, K1 = 0.01 and K2 = 0.03. Beyond the borders the outermost pixels go
/// on. 1 for identical pictures. Both spans hold width * height values, at least one.
double mean_ssim(std::span<const float> reference_luma, std::span<const float> luma, u32 width, u32 height);

}  // namespace raywalk
