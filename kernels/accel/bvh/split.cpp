// Host only: binned surface area heuristic, and the median division that bounds the depth.
#include "kernels/accel/bvh/split.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace raywalk::bvh {
namespace {

// Below this one thread is faster.
constexpr size_t kParallelCount = 1u << 16;
constexpr size_t kGrain = 1u << 14;

/// Folds every reference into a copy of `zero` by `add`, and copies into each other by `join`. The result must not
/// depend on the grouping.
template <class Value, class Add, class Join>
Value reduce(std::span<const Reference> range, const Value& zero, const Add& add, const Join& join) {
  const auto fold = [&](Value& value, std::span<const Reference> part) {
    for (const Reference& r : part) add(value, r);
  };
  if (range.size() < kParallelCount) {
    Value value = zero;
    fold(value, range);
    return value;
  }
  return tbb::parallel_reduce(
      tbb::blocked_range<size_t>(0, range.size(), kGrain), zero,
      [&](const tbb::blocked_range<size_t>& part, Value value) {
        fold(value, range.subspan(part.begin(), part.size()));
        return value;
      },
      [&](Value a, const Value& b) {
        join(a, b);
        return a;
      });
}

Box centroid_bounds(std::span<const Reference> range) {
  return reduce(
      range, Box{}, [](Box& box, const Reference& r) { box.add(r.centroid()); },
      [](Box& a, const Box& b) { a.add(b); });
}

struct Bin {
  Box box;
  u32 count = 0;
  void add(const Bin& other) {
    box.add(other.box);
    count += other.count;
  }
};

/// Maps centroids to bins along each axis. An axis without extent, or with one beyond the float range, is not used.
struct Binning {
  u32 bins;
  Vec3 lo, scale;

  Binning(const Box& centroids, u32 bins_an_axis) : bins(bins_an_axis), lo(centroids.lo) {
    const Vec3 extent = centroids.extent();
    scale = {scale_of(extent.x), scale_of(extent.y), scale_of(extent.z)};
  }
  bool uses(u32 axis) const { return scale[axis] > 0.0f; }
  u32 bin(Vec3 centroid, u32 axis) const {
    return std::min(bins - 1, static_cast<u32>((centroid[axis] - lo[axis]) * scale[axis]));
  }

 private:
  float scale_of(float extent) const {
    const float s = static_cast<float>(bins) / extent;
    return is_finite(extent) && is_finite(s) ? s : 0.0f;
  }
};

/// Room for `kCapacity` bins an axis: most ranges are small, and clearing bins that they do not use would take longer
/// than filling those they do.
template <u32 kCapacity>
struct Bins {
  Bin bin[3][kCapacity];
};

struct Plane {
  float cost = kMaxFloat;
  u32 axis = 0, bin = 0;  // the left side is below `bin`; 0: there is no plane
  Division division{};
};

/// The cheapest plane along one axis; `best` is replaced when it is cheaper. Costs lack the common factors.
void sweep(const Bin* bin, u32 bins, u32 axis, Plane& best) {
  float right_cost[kMaxBins];
  Box right_box[kMaxBins];
  Bin right;
  for (u32 i = bins - 1; i > 0; --i) {
    right.add(bin[i]);
    right_box[i] = right.box;
    right_cost[i] = right.count ? right.box.area() * static_cast<float>(right.count) : kMaxFloat;
  }
  Bin left;
  for (u32 i = 1; i < bins; ++i) {
    left.add(bin[i - 1]);
    if (left.count == 0) continue;
    const float cost = left.box.area() * static_cast<float>(left.count) + right_cost[i];
    if (cost < best.cost) best = {cost, axis, i, {left.count, left.box, right_box[i]}};
  }
}

template <u32 kCapacity>
Plane cheapest_plane(std::span<const Reference> range, const Binning& binning) {
  using Storage = Bins<kCapacity>;
  const Storage bins = reduce(
      range, Storage{},
      [&](Storage& to, const Reference& r) {
        const Vec3 c = r.centroid();
        for (u32 axis = 0; axis < 3; ++axis) {
          if (!binning.uses(axis)) continue;
          Bin& bin = to.bin[axis][binning.bin(c, axis)];
          bin.box.add(Box{r.lo, r.hi});
          ++bin.count;
        }
      },
      [&](Storage& to, const Storage& from) {
        for (u32 axis = 0; axis < 3; ++axis) {
          for (u32 i = 0; i < binning.bins; ++i) to.bin[axis][i].add(from.bin[axis][i]);
        }
      });
  Plane best;
  for (u32 axis = 0; axis < 3; ++axis) {
    if (binning.uses(axis)) sweep(bins.bin[axis], binning.bins, axis, best);
  }
  return best;
}

}  // namespace

Box bounds_of(std::span<const Reference> range) {
  return reduce(
      range, Box{},
      [](Box& box, const Reference& r) {
        box.add(Box{r.lo, r.hi});
      },
      [](Box& a, const Box& b) { a.add(b); });
}

Division divide_by_sah(std::span<Reference> range, const Box& box, const Config& config) {
  const u32 count = static_cast<u32>(range.size());
  // Few triangles do not fill many bins.
  const Binning binning(centroid_bounds(range), std::min(config.bins, std::max(4u, 2 * count)));
  const Plane plane = binning.bins <= 8    ? cheapest_plane<8>(range, binning)
                      : binning.bins <= 32 ? cheapest_plane<32>(range, binning)
                                           : cheapest_plane<kMaxBins>(range, binning);
  if (count <= config.max_leaf) {
    const float area = box.area();
    const float as_leaf = config.intersection_cost * static_cast<float>(count) * area;
    const float divided = config.traversal_cost * area + config.intersection_cost * plane.cost;
    if (plane.bin == 0 || !(divided < as_leaf)) return {};
  }
  if (plane.bin == 0) return divide_in_half(range);
  std::partition(range.begin(), range.end(),
                 [&](const Reference& r) { return binning.bin(r.centroid(), plane.axis) < plane.bin; });
  return plane.division;
}

Division divide_in_half(std::span<Reference> range) {
  const Vec3 extent = centroid_bounds(range).extent();
  const u32 axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const size_t half = range.size() / 2;
  std::nth_element(range.begin(), range.begin() + static_cast<std::ptrdiff_t>(half), range.end(),
                   [axis](const Reference& a, const Reference& b) {
                     const float ca = a.centroid()[axis], cb = b.centroid()[axis];
                     return ca < cb || (ca == cb && a.id < b.id);
                   });
  return {static_cast<u32>(half), bounds_of(range.first(half)), bounds_of(range.subspan(half))};
}

}  // namespace raywalk::bvh
