// Host only: which cells a triangle goes into.
#pragma once
#include <algorithm>
#include <cmath>

#include "kernels/accel/grid/layout.h"

namespace raywalk::grid {

/// Inclusive ranges of cells.
struct CellRange {
  i32 first[3], last[3];
  u64 count() const {
    u64 n = 1;
    for (int axis = 0; axis < 3; ++axis) n *= static_cast<u64>(last[axis] - first[axis] + 1);
    return n;
  }
};

/// The cells that the padded bounds of a finite triangle overlap.
inline CellRange cells_of(const Header& grid, const Corners& triangle) {
  const Box box = padded_bounds(grid.frame, triangle);
  CellRange range;
  for (u32 axis = 0; axis < 3; ++axis) {
    range.first[axis] = grid.cell_of(axis, box.lo[axis]);
    range.last[axis] = grid.cell_of(axis, box.hi[axis]);
  }
  return range;
}

/// Separating-axis test of one triangle against padded cells: three face normals of the cell are left to `cells_of`;
/// here are the triangle's normal and the nine cross products of edges. After Akenine-Moeller, "Fast 3D Triangle-Box
/// Overlap Testing", 2001, in double precision.
class TriangleOverlap {
 public:
  TriangleOverlap(const Header& grid, const Corners& triangle) : grid_(grid) {
    const Vec3 corners[3] = {triangle.a, triangle.b, triangle.c};
    for (u32 axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < 3; ++i) p_[i][axis] = double{corners[i][axis]} - double{grid.frame.centre[axis]};
      half_[axis] = 0.5 * double{grid.cell[axis]} + double{grid.frame.pad};
    }
    for (int i = 0; i < 3; ++i) {
      const double* from = p_[i];
      const double* to = p_[(i + 1) % 3];
      const double edge[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
      for (int axis = 0; axis < 3; ++axis) {
        const int j = (axis + 1) % 3, k = (axis + 2) % 3;
        double direction[3] = {};
        direction[j] = -edge[k];
        direction[k] = edge[j];
        add(direction);
      }
    }
    double e[3], f[3];
    for (int axis = 0; axis < 3; ++axis) {
      e[axis] = p_[1][axis] - p_[0][axis];
      f[axis] = p_[2][axis] - p_[0][axis];
    }
    const double normal[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    add(normal);
  }

  bool overlaps(i32 x, i32 y, i32 z) const {
    const i32 cell[3] = {x, y, z};
    double centre[3];
    for (u32 axis = 0; axis < 3; ++axis) {
      centre[axis] = (cell[axis] + 0.5) * double{grid_.cell[axis]} - double{grid_.frame.half[axis]};
    }
    for (int i = 0; i < count_; ++i) {
      const Slab& slab = slabs_[i];
      const double at = slab.direction[0] * centre[0] + slab.direction[1] * centre[1] + slab.direction[2] * centre[2];
      if (at < slab.low || at > slab.high) return false;
    }
    return true;
  }

 private:
  /// Cell centres outside [low, high] along the direction are separated from the triangle.
  struct Slab {
    double direction[3];
    double low, high;
  };
  void add(const double (&d)[3]) {
    double at[3], radius = 0;
    for (int i = 0; i < 3; ++i) at[i] = d[0] * p_[i][0] + d[1] * p_[i][1] + d[2] * p_[i][2];
    for (int axis = 0; axis < 3; ++axis) radius += std::abs(d[axis]) * half_[axis];
    const auto [low, high] = std::minmax({at[0], at[1], at[2]});
    slabs_[count_++] = {{d[0], d[1], d[2]}, low - radius, high + radius};
  }

  const Header& grid_;
  double p_[3][3];
  double half_[3];
  Slab slabs_[10];
  int count_ = 0;
};

}  // namespace raywalk::grid
