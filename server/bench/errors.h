// How far hits and images are from those of a reference.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernels/ray.h"
#include "server/bench/verdicts.h"
#include "server/device/device.h"

namespace raywalk {

/// Sums over the compared frames.
struct ErrorFigures {
  std::string reference;  // technique, as <structure>/<traversal>
  u64 frames = 0;
  u64 pixels = 0;  // whose hits were compared
  u64 id_mismatches = 0;
  u64 ties = 0;                 // another id at a t within 2 ulp: not a mismatch
  RayVerdicts primary, shadow;  // shadow rays in modes with shadows alone
  u64 images = 0;               // compared; the figures below are of them
  u64 image_pixels = 0;
  u64 changed_pixels = 0;    // with another 8-bit value in some channel
  double squared_error = 0;  // of sRGB-encoded values in 0..1, over all channels
  double ssim_sum = 0, flip_sum = 0;
  double flip_p99 = 0, flip_max = 0;  // of the worst image

  u64 checked_rays() const { return primary.rays + shadow.rays; }
  u64 wrong_rays() const { return primary.wrong() + shadow.wrong(); }
  double wrong_ppm() const;
  /// As mismatch_ppm_upper95.
  double wrong_ppm_upper95() const;
  double mismatch_ppm() const;
  /// Upper end of the one-sided 95 % interval of the rate; 3/N when no mismatch was seen.
  double mismatch_ppm_upper95() const;
  /// 0 when no image was compared.
  double image_rmse() const;
  /// Means over the images, and a share of all their pixels; none when no image was compared.
  std::optional<double> image_ssim() const;
  std::optional<double> image_flip_mean() const;
  std::optional<double> image_flip_p99() const;
  std::optional<double> image_flip_max() const;
  std::optional<double> changed_pixels_ppm() const;
  /// Adds all that `other` has of rays.
  void add_rays(const ErrorFigures& other);

 private:
  std::optional<double> of_images(double figure) const;
};

/// Both spans hold the hits of the same rays. Returns the numbers of those that differ, ties apart.
std::vector<u32> compare_hits(std::span<const Hit> reference, std::span<const Hit> hits, ErrorFigures& figures);

/// Linear RGB of the same size.
void compare_images(const Frame& reference, const Frame& image, ErrorFigures& figures);

}  // namespace raywalk
