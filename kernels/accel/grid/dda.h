// Grid traversal `grid/dda`: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987.
// The distance to a border is computed from the border's number, never accumulated: per axis the distances ascend with
// the number, so the merge of the three sequences visits every cell the ray crosses.
#pragma once
#include "kernels/accel/grid/wide.h"

namespace raywalk::grid::dda {

/// One axis of the walk.
struct Walk {
  i32 cell;
  i32 step;    // -1 or +1
  i32 stride;  // of the cell number
  i32 left;    // steps until the ray leaves the grid
  float next;  // distance to the border ahead

  RW_FN void look_ahead(const Header& grid, const LocalRay& ray, u32 axis) {
    next = (grid.border(axis, cell + (step > 0 ? 1 : 0)) - ray.o[axis]) * ray.inverse[axis];
  }
  RW_FN void start(const Header& grid, const LocalRay& ray, u32 axis, i32 cell_stride) {
    cell = grid.cell_of(axis, ray.o[axis]);
    step = ray.d[axis] > 0.0f ? 1 : -1;
    stride = step * cell_stride;
    left = step > 0 ? static_cast<i32>(grid.resolution[axis]) - 1 - cell : cell;
    look_ahead(grid, ray, axis);
  }
  /// False when the ray leaves the grid.
  RW_FN bool advance(const Header& grid, const LocalRay& ray, u32 axis, u32& number) {
    if (left-- == 0) return false;
    cell += step;
    number += static_cast<u32>(stride);
    look_ahead(grid, ray, axis);
    return true;
  }
};

/// The ray is valid.
template <class Query, class Counter>
RW_FN void traverse(const u8* blob, SceneView scene, const Ray& ray, Query& query, Counter& counter) {
  const Header grid = header_of<Header>(blob);  // a copy stays in registers
  LocalRay local;
  if (!enter(grid.frame, ray, local)) return;
  if (local.wide()) return traverse_wide(blob, scene, local, query, counter);

  const u32* begins = data_of(blob, grid.begins);
  const u32* references = data_of(blob, grid.references);
  const Corners* corners = scene.corners();
  Walk x, y, z;
  x.start(grid, local, 0, 1);
  y.start(grid, local, 1, static_cast<i32>(grid.resolution[0]));
  z.start(grid, local, 2, static_cast<i32>(grid.resolution[0] * grid.resolution[1]));
  u32 number = grid.number(x.cell, y.cell, z.cell);
  float limit = smaller(local.limit(query.tmax()), local.exit);
  while (true) {
    counter.step();
    const u32 begin = begins[number], end = begins[number + 1];
    if (begin != end) {
      if (test_cell(references, begin, end, corners, query, counter)) return;
      limit = smaller(local.limit(query.tmax()), local.exit);
    }
    bool inside;
    if (x.next <= y.next && x.next <= z.next) {
      if (limit < x.next) return;
      inside = x.advance(grid, local, 0, number);
    } else if (y.next <= z.next) {
      if (limit < y.next) return;
      inside = y.advance(grid, local, 1, number);
    } else {
      if (limit < z.next) return;
      inside = z.advance(grid, local, 2, number);
    }
    if (!inside) return;
  }
}

}  // namespace raywalk::grid::dda
