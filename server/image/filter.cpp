// Both directions of a filter are one loop with another step.
#include "server/image/filter.h"

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

namespace raywalk {
namespace {

std::size_t padded(std::size_t width) {
  return (width + Plane::kVector - 1) / Plane::kVector * Plane::kVector;
}

/// out[x] = sum over k of taps[k] * in[x + k * step].
void weighted_sums(const float* in, std::size_t step, const Taps& taps, float* out, std::size_t padded_width) {
  for (std::size_t x = 0; x < padded_width; x += Plane::kVector) {
    std::array<float, Plane::kVector> sums{};
    const float* from = in + x;
    for (const float tap : taps) {
      for (std::size_t i = 0; i < Plane::kVector; ++i) sums[i] += tap * from[i];
      from += step;
    }
    std::copy(sums.begin(), sums.end(), out + x);
  }
}

u32 reach(const Taps& taps) {
  return static_cast<u32>(taps.size() / 2);
}

}  // namespace

Taps gaussian_taps(double sigma, int radius) {
  std::vector<double> weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-x * x / (2.0 * sigma * sigma)));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  Taps taps;
  for (const double weight : weights) taps.push_back(static_cast<float>(weight / sum));
  return taps;
}

Plane::Plane(u32 width, u32 rows, u32 margin)
    : width_(width),
      rows_(rows),
      margin_(margin),
      stride_(padded(width) + 2 * std::size_t{margin}),
      values_(stride_ * rows) {}

void Plane::clamp_columns() {
  for (u32 y = 0; y < rows_; ++y) {
    float* values = row(y);
    float* last = values + margin_ + width_ - 1;
    std::fill(values, values + margin_, values[margin_]);
    std::fill(last + 1, values + stride_, *last);
  }
}

Plane filtered_across(const Plane& plane, const Taps& taps) {
  Plane out(plane.width(), plane.rows(), 0);
  const u32 first = plane.margin() - reach(taps);
  for (u32 y = 0; y < plane.rows(); ++y) weighted_sums(plane.row(y) + first, 1, taps, out.row(y), out.stride());
  return out;
}

Plane filtered_down(const Plane& plane, const Taps& taps, u32 halo) {
  Plane out(plane.width(), plane.rows() - 2 * halo, 0);
  const u32 first = halo - reach(taps);
  for (u32 y = 0; y < out.rows(); ++y) {
    weighted_sums(plane.row(y + first), plane.stride(), taps, out.row(y), out.stride());
  }
  return out;
}

bool is_same(const Strip& strip, std::span<const float> a, std::span<const float> b, std::size_t row_floats,
             u32 height) {
  const std::size_t first = strip.source_row(0, height), last = strip.source_row(strip.loaded_rows() - 1, height);
  return std::memcmp(a.data() + row_floats * first, b.data() + row_floats * first,
                     (last - first + 1) * row_floats * sizeof(float)) == 0;
}

}  // namespace raywalk
