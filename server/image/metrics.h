// How different two pictures are, in the field's usual figures.
#pragma once
#include <optional>

#include "server/device/device.h"

namespace raywalk {

/// Of pictures as they are shown: sRGB-encoded, clipped to 0..1; NaN is shown as 0.
struct ImageMetrics {
  u64 pixels = 0;
  u64 changed_pixels = 0;                            // with another 8-bit value in some channel
  double squared_error = 0;                          // sum over all channels
  double ssim = 1;                                   // mean over the pixels, of Rec. 709 luma
  double flip_mean = 0, flip_p99 = 0, flip_max = 0;  // 0..1; p99 by the nearest rank

  double rmse() const;
  std::optional<double> psnr_db() const;  // none for identical pictures
};

/// Compares linear RGB frames; the result does not depend on the number of threads. Throws std::logic_error unless both
/// have three channels, the same size and a pixel.
ImageMetrics compare_pictures(const Frame& reference, const Frame& image);

}  // namespace raywalk
