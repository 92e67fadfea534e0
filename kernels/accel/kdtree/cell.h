// Host only: a node's cell, the part of a triangle inside it, and the cost of splitting it.
#pragma once
#include <algorithm>
#include <limits>

#include "kernels/accel/kdtree/build.h"
#include "kernels/accel/padded_frame.h"

namespace raywalk::kdtree {

/// Box by axis, in the frame.
struct Cell {
  float lo[3], hi[3];
  double extent(int axis) const { return double{hi[axis]} - double{lo[axis]}; }
  /// Half the surface area.
  double half_area() const { return extent(0) * extent(1) + extent(1) * extent(2) + extent(2) * extent(0); }
};

/// A triangle as its part inside a node's cell sees it: padded bounds of that part.
struct Part {
  Cell bounds;
  u32 id;
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  int axis = 0;
  float position = 0;
};

/// 0: the part lies left of the plane, 1: right, 2: on both sides.
inline int side_of(const Part& part, const Split& split) {
  if (part.bounds.hi[split.axis] <= split.position) return 0;
  return part.bounds.lo[split.axis] >= split.position ? 1 : 2;
}

inline Cell child_of(Cell cell, const Split& split, int side) {
  (side == 0 ? cell.hi : cell.lo)[split.axis] = split.position;
  return cell;
}

/// Keeps the cheapest split of one cell along one axis.
class CheapestSplit {
 public:
  CheapestSplit(const Config& config, const Cell& cell, int axis)
      : config_(config), lo_(cell.lo[axis]), hi_(cell.hi[axis]) {
    const double a = cell.extent((axis + 1) % 3), b = cell.extent((axis + 2) % 3);
    face_ = a * b;
    rim_ = a + b;
    per_area_ = config.intersection_cost / cell.half_area();
    best_.axis = axis;
  }
  /// The plane must be inside the cell to count.
  void consider(float position, u64 left, u64 right) {
    if (!(position > lo_ && position < hi_)) return;
    const double areas = (face_ + rim_ * (double{position} - double{lo_})) * static_cast<double>(left) +
                         (face_ + rim_ * (double{hi_} - double{position})) * static_cast<double>(right);
    double cost = config_.traversal_cost + per_area_ * areas;
    if (left == 0 || right == 0) cost *= 1.0 - config_.empty_bonus;
    if (cost < best_.cost) {
      best_.cost = cost;
      best_.position = position;
    }
  }
  const Split& best() const { return best_; }

 private:
  const Config& config_;
  float lo_, hi_;
  double face_, rim_, per_area_;
  Split best_;
};

inline const Split& cheaper(const Split& a, const Split& b) {
  return b.cost < a.cost ? b : a;
}

/// Shrinks `part`, a part of `triangle` in the parent's cell, to the child's cell ("perfect split"). Returns false when
/// no point within the padding of the triangle is inside the child.
bool clip(const PaddedFrame& frame, const Corners& triangle, const Cell& child, Part& part);

}  // namespace raywalk::kdtree
