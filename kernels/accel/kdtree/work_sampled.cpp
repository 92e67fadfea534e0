// Sampled SAH: bins the bounds of at most a few thousand parts and considers the borders of the bins.
#include <tbb/parallel_for.h>

#include "kernels/accel/kdtree/work.h"

namespace raywalk::kdtree {
namespace {

constexpr int kBins = 128;
constexpr u32 kSample = 8192;  // parts looked at in one node

struct Bins {
  u32 starts[kBins] = {}, ends[kBins] = {};
};

}  // namespace

Split SampledWork::find_split(const Config& config, const Cell& cell) const {
  if (parts_.empty()) return {};
  // Bins span the bounds of all parts, so that the outermost borders cut off empty space exactly.
  Cell all = parts_[0].bounds;
  for (const Part& part : parts_) {
    for (int axis = 0; axis < 3; ++axis) {
      all.lo[axis] = std::min(all.lo[axis], part.bounds.lo[axis]);
      all.hi[axis] = std::max(all.hi[axis], part.bounds.hi[axis]);
    }
  }
  const u32 stride = (size() + kSample - 1) / kSample;
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    Bins bins;
    u32 sampled = 0;
    const float lo = all.lo[axis], width = all.hi[axis] - lo;
    const float scale = width > 0.0f ? kBins / width : 0.0f;
    const auto bin_of = [&](float position) {
      return std::clamp(static_cast<int>((position - lo) * scale), 0, kBins - 1);
    };
    for (u32 i = 0; i < size(); i += stride) {
      ++bins.starts[bin_of(parts_[i].bounds.lo[axis])];
      ++bins.ends[bin_of(parts_[i].bounds.hi[axis])];
      ++sampled;
    }
    CheapestSplit cheapest(config, cell, axis);
    cheapest.consider(lo, 0, size());
    cheapest.consider(all.hi[axis], size(), 0);
    const double weight = static_cast<double>(size()) / sampled;
    u32 left = 0, right = sampled;
    for (int i = 1; i < kBins; ++i) {
      left += bins.starts[i - 1];
      right -= bins.ends[i - 1];
      const auto estimate = [&](u32 n) { return std::max<u64>(1, static_cast<u64>(weight * n)); };
      cheapest.consider(lo + width * (static_cast<float>(i) / kBins), estimate(left), estimate(right));
    }
    best = cheaper(best, cheapest.best());
  }
  return best;
}

void SampledWork::split(const Source& source, const Cell& cell, const Split& split, SampledWork (&out)[2]) {
  for (const int side : {0, 1}) {
    const Cell child = child_of(cell, split, side);
    for (const Part& part : parts_) {
      const int at = side_of(part, split);
      if (at != 2 && at != side) continue;
      Part kept = part;
      if (at == 2 && !clip(source.frame, source.corners[part.id], child, kept)) continue;
      out[side].parts_.push_back(kept);
    }
    out[side].parts_.shrink_to_fit();
  }
  std::vector<Part>().swap(parts_);
}

}  // namespace raywalk::kdtree
