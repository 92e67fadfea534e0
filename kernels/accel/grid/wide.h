// Grid traversal of a wide ray (see padded_frame.h): slices along the ray's main axis, in each all cells that the beam
// touches.
#pragma once
#include "kernels/accel/grid/layout.h"
#include "kernels/query.h"

namespace raywalk::grid {

/// The cells along one axis that the beam touches for s in [from, to].
RW_FN void touched_cells(const Header& grid, const LocalRay& ray, u32 axis, float from, float to, i32& first,
                         i32& last) {
  const float a = fma(from, ray.d[axis], ray.o[axis]), b = fma(to, ray.d[axis], ray.o[axis]);
  first = grid.cell_of(axis, smaller(a, b) - ray.radius);
  last = grid.cell_of(axis, larger(a, b) + ray.radius);
}

template <class Query, class Counter>
RW_FN void traverse_wide(const u8* blob, SceneView scene, const LocalRay& ray, Query& query, Counter& counter) {
  const Header& grid = header_of<Header>(blob);
  const u32* begins = data_of(blob, grid.begins);
  const u32* references = data_of(blob, grid.references);
  const auto* records = records_by_id<Query, Header>(blob, scene);
  const Vec3 size = magnitude(ray.d);
  const u32 main = size.x >= size.y && size.x >= size.z ? 0u : size.y >= size.z ? 1u : 2u;
  const bool ascending = ray.d[main] > 0.0f;

  i32 first, last;
  touched_cells(grid, ray, main, 0.0f, ray.exit, first, last);
  for (i32 n = 0; n <= last - first; ++n) {
    const i32 slice = ascending ? first + n : last - n;
    const float low = grid.border(main, slice) - ray.radius, high = grid.border(main, slice + 1) + ray.radius;
    const float from = larger(((ascending ? low : high) - ray.o[main]) * ray.inverse[main], 0.0f);
    const float to = smaller(((ascending ? high : low) - ray.o[main]) * ray.inverse[main], ray.exit);
    if (ray.limit(query.tmax()) < from) return;
    i32 from_cell[3], to_cell[3];
    for (u32 axis = 0; axis < 3; ++axis) touched_cells(grid, ray, axis, from, to, from_cell[axis], to_cell[axis]);
    from_cell[main] = to_cell[main] = slice;
    for (i32 z = from_cell[2]; z <= to_cell[2]; ++z) {
      for (i32 y = from_cell[1]; y <= to_cell[1]; ++y) {
        for (i32 x = from_cell[0]; x <= to_cell[0]; ++x) {
          counter.step();
          const u32 cell = grid.number(x, y, z);
          if (test_cell(references, begins[cell], begins[cell + 1], records, query, counter)) return;
        }
      }
    }
  }
}

}  // namespace raywalk::grid
