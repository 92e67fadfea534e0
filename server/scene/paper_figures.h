// The study's published figures for one scene: its rows of Tables 1 and 2.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "kernels/platform.h"

namespace raywalk {

/// One structure of Table 1; `leaves_thousands` and `references_per_triangle` are absent where the table has none.
struct PaperStructure {
  std::optional<double> references_per_triangle;
  std::optional<double> leaves_thousands;
  double size_mb;
  double steps_per_ray;
  double tests_per_ray;
};

/// Frame times of Table 2 in milliseconds at 1024x1024; absent where the table has a dash.
struct PaperTimes {
  std::optional<double> grid, kdt3, kdt2, bvh;
};

struct PaperFigures {
  std::string source;
  u64 triangles;
  u32 lights;
  std::array<u32, 3> grid_cells;
  PaperStructure grid, kdtree, bvh;
  PaperTimes primary_ms, shadow_ms, whitted_ms;
};

}  // namespace raywalk
