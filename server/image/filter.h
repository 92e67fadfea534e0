// Separable filters over strips of an image: rows with their neighbours, each strip on its own.
#pragma once
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

/// Weights of 2 r + 1 neighbours. Their sum is the caller's business.
using Taps = std::vector<float>;

/// exp(-x^2 / 2 sigma^2) at -radius..radius, scaled to the sum 1.
Taps gaussian_taps(double sigma, int radius);

/// One value a pixel. Rows are padded to whole vectors, so that filters have no remainder.
class Plane {
 public:
  static constexpr std::size_t kVector = 32;  // floats that a filter holds in registers

  Plane(u32 width, u32 rows, u32 margin);

  float* row(u32 y) { return values_.data() + y * stride_; }
  const float* row(u32 y) const { return values_.data() + y * stride_; }
  u32 width() const { return width_; }  // without the margin
  u32 rows() const { return rows_; }
  u32 margin() const { return margin_; }  // columns before the first and after the last
  std::size_t stride() const { return stride_; }
  /// Gives the margins the values of the first and the last column.
  void clamp_columns();

 private:
  u32 width_, rows_, margin_;
  std::size_t stride_;
  std::vector<float> values_;
};

/// Rows filtered along themselves: a plane without margin. `taps` reach no farther than the margin.
Plane filtered_across(const Plane& plane, const Taps& taps);

/// A plane without margin filtered along its columns; `halo` rows less at either end, no fewer than `taps` reach.
Plane filtered_down(const Plane& plane, const Taps& taps, u32 halo);

/// Rows [begin, end) of an image, and how many neighbours they need above and below.
struct Strip {
  u32 begin, end, halo;

  u32 rows() const { return end - begin; }
  u32 loaded_rows() const { return rows() + 2 * halo; }
  /// The image's row that row `i` of a loaded plane holds: beyond the borders the outermost.
  u32 source_row(u32 i, u32 height) const { return i + begin < halo ? 0 : std::min(i + begin - halo, height - 1); }
};

/// Whether two images of `row_floats` a row hold the same bits in a strip and its neighbours.
bool is_same(const Strip& strip, std::span<const float> a, std::span<const float> b, std::size_t row_floats,
             u32 height);

constexpr u32 kStripRows = 64;

inline u32 strip_count(u32 height) {
  return (height + kStripRows - 1) / kStripRows;
}

/// Calls f(strip, number) for all strips of an image in parallel. The cut does not depend on the number of threads.
template <class F>
void for_strips(u32 height, u32 halo, F&& f) {
  tbb::parallel_for(0u, strip_count(height), [&](u32 number) {
    f(Strip{number * kStripRows, std::min((number + 1) * kStripRows, height), halo}, number);
  });
}

}  // namespace raywalk
