// Building by the surface area heuristic in bins along the widest axis.
#include "server/accuracy/oracle/beam_tree.h"

#include <array>

namespace raywalk::oracle {
namespace {

constexpr u32 kBins = 16;

/// In double, since the area of a large box is no float.
double half_area(const Box& box) {
  if (box.empty()) return 0.0;
  const Double3 e = between(box.lo, box.hi);
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

double middle(const Box& box, u32 axis) {
  return 0.5 * (double{box.lo[axis]} + double{box.hi[axis]});
}

/// The middles of boxes along their widest axis.
struct Spread {
  u32 axis;
  double low, width;

  u32 bin_of(const Box& box) const {
    return std::min(static_cast<u32>((middle(box, axis) - low) / width * kBins), kBins - 1);
  }
};

struct Bin {
  Box box;
  u32 count = 0;

  void add(const Bin& other) {
    box.add(other.box);
    count += other.count;
  }
  double cost() const { return half_area(box) * count; }
};

/// The first bin of the right side, so that the costs of both sides are least.
u32 best_split(const std::array<Bin, kBins>& bins) {
  std::array<double, kBins> right_cost{};
  Bin right;
  for (u32 i = kBins - 1; i > 0; --i) {
    right.add(bins[i]);
    right_cost[i] = right.cost();
  }
  Bin left;
  u32 best = kBins / 2;
  double least = 1e300;
  for (u32 i = 1; i < kBins; ++i) {
    left.add(bins[i - 1]);
    const double cost = left.cost() + right_cost[i];
    if (cost < least) {
      least = cost;
      best = i;
    }
  }
  return best;
}

}  // namespace

BeamTree::BeamTree(SceneView scene) {
  std::vector<Item> items;
  items.reserve(scene.triangle_count());
  for (u32 i = 0; i < scene.triangle_count(); ++i) {
    const Corners& triangle = scene.corners()[i];
    if (is_finite(triangle)) items.push_back({bounds_of(triangle), i});
  }
  if (items.empty()) return;
  nodes_.reserve(items.size());
  order_.reserve(items.size());
  build(items.data(), items.data() + items.size(), 0);
}

void BeamTree::build(Item* first, Item* last, u32 depth) {
  Box box;
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
  for (const Item* item = first; item != last; ++item) {
    box.add(item->box);
    for (u32 axis = 0; axis < 3; ++axis) {
      const double m = middle(item->box, axis);
      low[axis] = std::min(low[axis], m);
      high[axis] = std::max(high[axis], m);
    }
  }
  const auto count = static_cast<u32>(last - first);
  const auto index = static_cast<u32>(nodes_.size());
  nodes_.push_back({box, static_cast<u32>(order_.size()), count});
  if (count <= kLeafSize) {
    for (const Item* item = first; item != last; ++item) order_.push_back(item->number);
    return;
  }

  Spread spread{0, 0.0, -1.0};
  for (u32 axis = 0; axis < 3; ++axis) {
    if (high[axis] - low[axis] > spread.width) spread = {axis, low[axis], high[axis] - low[axis]};
  }
  Item* half = first;
  if (spread.width > 0.0 && depth < kMedianDepth) {
    std::array<Bin, kBins> bins;
    for (const Item* item = first; item != last; ++item) bins[spread.bin_of(item->box)].add({item->box, 1});
    const u32 split = best_split(bins);
    half = std::partition(first, last, [&](const Item& item) { return spread.bin_of(item.box) < split; });
  }
  if (half == first || half == last) {
    half = first + count / 2;
    std::nth_element(first, half, last, [axis = spread.axis](const Item& a, const Item& b) {
      return middle(a.box, axis) < middle(b.box, axis);
    });
  }
  nodes_[index].count = 0;
  build(first, half, depth + 1);
  nodes_[index].first = static_cast<u32>(nodes_.size());
  build(half, last, depth + 1);
}

}  // namespace raywalk::oracle
