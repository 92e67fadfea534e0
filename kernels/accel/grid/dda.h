// Grid traversal `grid/dda`: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987.
// The distance to a border is computed from the border's number, never accumulated: per axis the distances ascend with
// the number, so the merge of the three sequences visits every cell the ray crosses.
#pragma once
#include "kernels/accel/grid/wide.h"

namespace raywalk::grid::dda {

/// One axis of the walk. Numbers of borders are whole floats.
struct Walk {
  float ahead;        // number of the border ahead
  float end;          // number of the border where the ray leaves the grid
  float step;         // -1 or +1
  float size, start;  // of a cell; position of border 0 in the frame
  float origin, inverse;
  u32 stride;  // of the cell number, modulo 2^32
  float next;  // distance to the border ahead

  RW_FN i32 begin(const Header& grid, const LocalRay& ray, u32 axis, u32 cell_stride) {
    const i32 cell = grid.cell_of(axis, ray.o[axis]);
    const bool up = ray.d[axis] > 0.0f;
    ahead = static_cast<float>(up ? cell + 1 : cell);
    end = up ? static_cast<float>(grid.resolution[axis]) : 0.0f;
    step = up ? 1.0f : -1.0f;
    size = grid.cell[axis];
    start = -grid.frame.half[axis];
    origin = ray.o[axis];
    inverse = ray.inverse[axis];
    stride = up ? cell_stride : 0u - cell_stride;
    look_ahead();
    return cell;
  }
  RW_FN void look_ahead() { next = (fma(ahead, size, start) - origin) * inverse; }
  /// Whether the border ahead is the grid's own.
  RW_FN bool last() const { return ahead == end; }
  RW_FN void advance(bool taken) {
    ahead = ahead + (taken ? step : 0.0f);
    look_ahead();
  }
};

/// The ray is valid.
template <class Query, class Counter>
RW_FN void traverse(const u8* blob, SceneView scene, const Ray& ray, Query& query, Counter& counter) {
  const Header& grid = header_of<Header>(blob);
  LocalRay local;
  if (!enter(grid.frame, ray, local)) return;
  if (local.wide()) return traverse_wide(blob, scene, local, query, counter);

  const u32* begins = data_of(blob, grid.begins);
  const u32* references = data_of(blob, grid.references);
  const auto* records = records_by_id<Query, Header>(blob, scene);
  Walk x, y, z;
  const i32 cell_x = x.begin(grid, local, 0, 1);
  const i32 cell_y = y.begin(grid, local, 1, grid.resolution[0]);
  const i32 cell_z = z.begin(grid, local, 2, grid.resolution[0] * grid.resolution[1]);
  u32 number = grid.number(cell_x, cell_y, cell_z);
  float limit = smaller(local.limit(query.tmax()), local.exit);
  while (true) {
    counter.step();
    const u32 begin = begins[number], end = begins[number + 1];
    if (begin != end) {
      if (test_cell(references, begin, end, records, query, counter)) return;
      limit = smaller(local.limit(query.tmax()), local.exit);
    }
    // Without a branch on the axis: neighbouring rays take different ones.
    const bool take_x = x.next <= y.next && x.next <= z.next;
    const bool take_y = !take_x && y.next <= z.next;
    const bool take_z = !take_x && !take_y;
    if (limit < smaller(smaller(x.next, y.next), z.next)) return;
    if ((take_x && x.last()) || (take_y && y.last()) || (take_z && z.last())) return;
    number += take_x ? x.stride : take_y ? y.stride : z.stride;
    x.advance(take_x);
    y.advance(take_y);
    z.advance(take_z);
  }
}

}  // namespace raywalk::grid::dda
