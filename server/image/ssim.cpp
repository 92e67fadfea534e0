// Local means and variances are filtered planes.
#include "server/image/ssim.h"

#include <numeric>

#include "server/image/filter.h"

namespace raywalk {
namespace {

constexpr float kC1 = 0.01f * 0.01f, kC2 = 0.03f * 0.03f;
// Variances do not know of a shift; it keeps squares small, and with them what is lost in their differences.
constexpr float kShift = 0.5f;

/// What is filtered, of the two pictures x and y. The variance of the difference stands for the covariance: where the
/// pictures are alike it is small, and so is what rounding does to it.
struct Moments {
  Plane x, squares, difference, squared_difference;
};

Moments load(std::span<const float> xs, std::span<const float> ys, u32 width, u32 height, const Strip& strip) {
  const Plane empty(width, strip.loaded_rows(), kSsimReach);
  Moments m{empty, empty, empty, empty};
  for (u32 i = 0; i < strip.loaded_rows(); ++i) {
    const std::size_t first = std::size_t{strip.source_row(i, height)} * width;
    float *x = m.x.row(i) + kSsimReach, *squares = m.squares.row(i) + kSsimReach;
    float* difference = m.difference.row(i) + kSsimReach;
    float* squared_difference = m.squared_difference.row(i) + kSsimReach;
    for (u32 column = 0; column < width; ++column) {
      const float a = xs[first + column] - kShift, b = ys[first + column] - kShift, d = a - b;
      x[column] = a;
      squares[column] = a * a + b * b;
      difference[column] = d;
      squared_difference[column] = d * d;
    }
  }
  for (Plane* plane : {&m.x, &m.squares, &m.difference, &m.squared_difference}) plane->clamp_columns();
  return m;
}

double strip_sum(const Moments& m) {
  static const Taps taps = gaussian_taps(1.5, kSsimReach);
  const auto local = [](const Plane& plane) { return filtered_down(filtered_across(plane, taps), taps, kSsimReach); };
  const Plane x = local(m.x), squares = local(m.squares), difference = local(m.difference);
  const Plane squared_difference = local(m.squared_difference);
  double sum = 0;
  for (u32 row = 0; row < x.rows(); ++row) {
    for (u32 i = 0; i < x.width(); ++i) {
      const float a = x.row(row)[i], d = difference.row(row)[i], b = a - d;
      const float mean_x = a + kShift, mean_y = b + kShift;
      const float variances = squares.row(row)[i] - (a * a + b * b);
      const float of_difference = squared_difference.row(row)[i] - d * d;
      // 2 u v = u^2 + v^2 - (u - v)^2, for the means and for the deviations from them.
      const float luminance = 1.0f - d * d / (mean_x * mean_x + mean_y * mean_y + kC1);
      const float structure = 1.0f - of_difference / (variances + kC2);
      sum += static_cast<double>(luminance * structure);
    }
  }
  return sum;
}

}  // namespace

double mean_ssim(std::span<const float> reference_luma, std::span<const float> luma, u32 width, u32 height) {
  std::vector<double> sums(strip_count(height));
  for_strips(height, kSsimReach, [&](const Strip& strip, u32 number) {
    sums[number] = is_same(strip, reference_luma, luma, width, height)
                       ? static_cast<double>(width) * strip.rows()
                       : strip_sum(load(reference_luma, luma, width, height, strip));
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / (static_cast<double>(width) * height);
}

}  // namespace raywalk
