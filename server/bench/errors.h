// How far hits and images are from those of a reference.
#pragma once
#include <span>
#include <string>

#include "kernels/ray.h"

namespace raywalk {

/// Sums over the compared frames.
struct ErrorFigures {
  std::string reference;  // technique, as <structure>/<traversal>
  u64 frames = 0;
  u64 pixels = 0;  // whose hits were compared
  u64 id_mismatches = 0;
  u64 ties = 0;  // another id at a t within 2 ulp: not a mismatch
  u64 channels = 0;
  double squared_error = 0;  // of sRGB-encoded values in 0..1

  double mismatch_ppm() const;
  /// Upper end of the one-sided 95 % interval of the rate; 3/N when no mismatch was seen.
  double mismatch_ppm_upper95() const;
  /// 0 when no image was compared.
  double image_rmse() const;
};

/// Both spans hold the hits of the same rays.
void compare_hits(std::span<const Hit> reference, std::span<const Hit> hits, ErrorFigures& figures);

/// Linear values of images of the same size.
void compare_images(std::span<const float> reference, std::span<const float> image, ErrorFigures& figures);

}  // namespace raywalk
