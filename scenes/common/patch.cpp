// Tessellation of a patch: a grid of cells, some of which get a vertex in their middle to meet the count.
#include <algorithm>
#include <cmath>

#include "scenes/common/surface.h"

namespace raywalk {
namespace {

struct Grid {
  u64 columns, rows;
};

/// The grid of at most `cells` cells that are about as long as wide and waste few of them.
Grid grid_for(u64 cells, float aspect) {
  const double wish = std::sqrt(static_cast<double>(cells) * aspect);
  const u64 columns = std::clamp<u64>(static_cast<u64>(wish + 0.5), 1, cells);
  return {columns, cells / columns};
}

}  // namespace

void add_patch(TriangleSink& sink, const PatchShape& shape, float aspect, u32 material, u64 triangles) {
  const auto [columns, rows] = grid_for(triangles / 2, aspect);
  const u64 cells = columns * rows;
  const u64 middles = (triangles - 2 * cells) / 2;
  const bool odd = triangles % 2 != 0;

  const auto add_vertex = [&](double column, double row) {
    if (sink.counts_only()) return sink.add_vertex({}, {});
    const SurfacePoint p = shape(static_cast<float>(column / static_cast<double>(columns)),
                                 static_cast<float>(row / static_cast<double>(rows)));
    return sink.add_vertex(p.position, p.normal);
  };
  u32 first = 0;
  for (u64 row = 0; row <= rows; ++row) {
    for (u64 column = 0; column <= columns; ++column) {
      const u32 index = add_vertex(static_cast<double>(column), static_cast<double>(row));
      if (row == 0 && column == 0) first = index;
    }
  }

  const auto at = [&](u64 column, u64 row) { return static_cast<u32>(first + row * (columns + 1) + column); };
  const auto triangle = [&](u32 a, u32 b, u32 c) { sink.add_triangle({a, b, c, material}); };
  for (u64 cell = 0; cell < cells; ++cell) {
    const u64 row = cell / columns, column = cell % columns;
    const u32 a = at(column, row), b = at(column + 1, row), c = at(column + 1, row + 1), d = at(column, row + 1);
    // Spread evenly over the cells; at most one a cell, as fewer are missing than there are columns.
    const bool has_middle = (cell + 1) * middles / cells > cell * middles / cells;
    // One more triangle than an even number: the border edge a-b of the first cell is cut in two.
    const bool cut_border = odd && cell == 0;
    if (has_middle) {
      const u32 middle = add_vertex(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      triangle(b, c, middle);
      triangle(c, d, middle);
      triangle(d, a, middle);
      if (!cut_border) triangle(a, b, middle);
      if (cut_border) {
        const u32 half = add_vertex(0.5, 0.0);
        triangle(a, half, middle);
        triangle(half, b, middle);
      }
    } else if (cut_border) {
      const u32 half = add_vertex(0.5, 0.0);
      triangle(a, half, d);
      triangle(half, c, d);
      triangle(half, b, c);
    } else {
      triangle(a, b, c);
      triangle(a, c, d);
    }
  }
}

}  // namespace raywalk
