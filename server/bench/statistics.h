// Statistics of measured times.
#pragma once
#include <span>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

/// In the unit of the samples.
struct Statistics {
  double median = 0, mean = 0, sd = 0, mad = 0, min = 0, p5 = 0, p95 = 0, p99 = 0;
  double ci95_low = 0, ci95_high = 0;  // bootstrap interval of the median
  u64 samples = 0;
  bool unstable = false;
};

/// Above this spread over repeats of the same frame, times are `unstable`.
constexpr double kUnstableSpread = 0.035;

/// Linear interpolation between the neighbouring order statistics; `sorted` is not empty, `p` in [0, 1].
double percentile(std::span<const double> sorted, double p);

/// Relative standard deviation over repeats, pooled over frames; 0 when nothing was repeated.
double pooled_spread(std::span<const std::vector<double>> repeats_of_frames);

/// All samples of `repeats_of_frames` together. Deterministic: the bootstrap's generator is seeded.
/// Throws std::invalid_argument when there is no sample.
Statistics summarise(std::span<const std::vector<double>> repeats_of_frames);

}  // namespace raywalk
