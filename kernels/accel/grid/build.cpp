// Builds the uniform grid in two passes over the triangles: count the references of each cell, then fill them in.
#include "kernels/accel/grid/build.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>

#include "kernels/accel/build_records.h"
#include "kernels/accel/grid/insertion.h"

namespace raywalk::grid {
namespace {

using TriangleRange = tbb::blocked_range<u32>;

void for_each_triangle(SceneView scene, const auto& body) {
  tbb::parallel_for(TriangleRange(0, scene.triangle_count(), 1024), [&](const TriangleRange& range) {
    for (u32 i = range.begin(); i < range.end(); ++i) {
      if (is_finite(scene.corners()[i])) body(scene.corners()[i], i);
    }
  });
}

/// Calls visit(cell number) for each cell of a triangle.
void for_each_cell(const Header& grid, const Corners& triangle, Insertion insertion, const auto& visit) {
  const CellRange range = cells_of(grid, triangle);
  const auto for_range = [&](const auto& inside) {
    for (i32 z = range.first[2]; z <= range.last[2]; ++z) {
      for (i32 y = range.first[1]; y <= range.last[1]; ++y) {
        for (i32 x = range.first[0]; x <= range.last[0]; ++x) {
          if (inside(x, y, z)) visit(grid.number(x, y, z));
        }
      }
    }
  };
  if (insertion == Insertion::kExact && range.count() > 1) {
    const TriangleOverlap overlap(grid, triangle);
    for_range([&](i32 x, i32 y, i32 z) { return overlap.overlaps(x, y, z); });
  } else {
    for_range([](i32, i32, i32) { return true; });
  }
}

/// Cube-root rule: cells are cubes, `density` of them a triangle. Axes thinner than a cube get one layer and the others
/// share the cells.
void choose_resolution(const Config& config, u32 triangles, Header& grid) {
  const double cells = std::clamp(config.density * triangles, 1.0, static_cast<double>(kMaxCellsByDensity));
  bool thin[3] = {false, false, false};
  double size = 0;
  for (bool again = true; again;) {
    again = false;
    double volume = 1;
    int axes = 0;
    for (u32 axis = 0; axis < 3; ++axis) {
      if (thin[axis]) continue;
      volume *= 2.0 * double{grid.frame.half[axis]};
      ++axes;
    }
    size = std::pow(volume / cells, 1.0 / axes);
    for (u32 axis = 0; axis < 3 && axes > 1; ++axis) {
      if (!thin[axis] && 2.0 * double{grid.frame.half[axis]} < size) thin[axis] = again = true;
    }
  }
  for (u32 axis = 0; axis < 3; ++axis) {
    const double wanted = thin[axis] ? 1.0 : std::ceil(2.0 * double{grid.frame.half[axis]} / size);
    const u32 chosen = static_cast<u32>(std::clamp(wanted, 1.0, static_cast<double>(kMaxResolution)));
    grid.resolution[axis] = config.resolution[axis] != 0 ? config.resolution[axis] : chosen;
  }
}

std::string as_text(const Header& grid) {
  return std::to_string(grid.resolution[0]) + "x" + std::to_string(grid.resolution[1]) + "x" +
         std::to_string(grid.resolution[2]);
}

/// Everything but the slices.
Header make_header(SceneView scene, const Config& config) {
  Header grid{};
  grid.frame = padded_frame(scene.header().bounds);
  choose_resolution(config, scene.triangle_count(), grid);
  u64 cells = 1;
  for (u32 n : grid.resolution) {
    if (n > kMaxResolution)
      throw std::invalid_argument("grid: resolution " + as_text(grid) + " is over the limit of " +
                                  std::to_string(kMaxResolution) + " cells along an axis");
    cells *= n;
  }
  if (cells > kMaxCells) {
    throw std::invalid_argument("grid: resolution " + as_text(grid) + " is over the limit of " +
                                std::to_string(kMaxCells) + " cells");
  }
  double cell[3];
  for (u32 axis = 0; axis < 3; ++axis) cell[axis] = 2.0 * double{grid.frame.half[axis]} / grid.resolution[axis];
  grid.cell = {static_cast<float>(cell[0]), static_cast<float>(cell[1]), static_cast<float>(cell[2])};
  grid.inverse = {static_cast<float>(1 / cell[0]), static_cast<float>(1 / cell[1]), static_cast<float>(1 / cell[2])};
  return grid;
}

/// Overlaps of triangle bounds and cells; counting stops somewhere above kMaxCandidates.
u64 count_candidates(SceneView scene, const Header& grid) {
  return tbb::parallel_reduce(
      TriangleRange(0, scene.triangle_count(), 1024), u64{0},
      [&](const TriangleRange& range, u64 sum) {
        for (u32 i = range.begin(); i < range.end() && sum <= kMaxCandidates; ++i) {
          if (is_finite(scene.corners()[i])) sum += cells_of(grid, scene.corners()[i]).count();
        }
        return sum;
      },
      std::plus<u64>{});
}

/// The grid that is asked for. Refuses one whose references could not be held, before anything is allocated. Where the
/// density decides, it is halved until triangles that are large against the cells do not fill the memory.
Header settled_header(SceneView scene, Config config) {
  Header grid = make_header(scene, config);
  if (config.resolution[0] != 0 || config.resolution[1] != 0 || config.resolution[2] != 0) {
    if (count_candidates(scene, grid) <= kMaxCandidates) return grid;
    throw std::invalid_argument("grid: at resolution " + as_text(grid) + " the triangles overlap more than " +
                                std::to_string(kMaxCandidates) + " cells; choose fewer cells");
  }
  const u64 most = kCandidatesATriangle * scene.triangle_count() + kFreeCandidates;
  while (config.density * scene.triangle_count() > 1.0 && count_candidates(scene, grid) > most) {
    config.density *= 0.5;
    grid = make_header(scene, config);
  }
  return grid;
}

}  // namespace

BuiltStructure build(SceneView scene, const Config& config) {
  const auto start = std::chrono::steady_clock::now();
  Header grid = settled_header(scene, config);
  const u64 cells = u64{grid.resolution[0]} * grid.resolution[1] * grid.resolution[2];

  // Threads add to one set of counters; the order of references is settled by a sort at the end.
  const auto cursors = std::make_unique<std::atomic<u32>[]>(cells);
  for_each_triangle(scene, [&](const Corners& triangle, u32) {
    for_each_cell(grid, triangle, config.insertion,
                  [&](u32 cell) { cursors[cell].fetch_add(1, std::memory_order_relaxed); });
  });
  u64 references = 0;
  for (u64 i = 0; i < cells; ++i) references += cursors[i].load(std::memory_order_relaxed);

  BlobPlan plan(sizeof(Header));
  grid.begins = plan.add<u32>(cells + 1);
  grid.references = plan.add<u32>(references);
  grid.transforms = plan.add<Transform>(config.triangles == TriangleRecords::transforms ? scene.triangle_count() : 0);
  BuiltStructure result{plan.allocate(), {}, {config.triangles}};
  std::memcpy(result.blob.data(), &grid, sizeof(Header));
  const std::span<u32> begins = slice_of(result.blob, grid.begins);
  const std::span<u32> ids = slice_of(result.blob, grid.references);
  u32 sum = 0;
  for (u64 i = 0; i < cells; ++i) {
    begins[i] = sum;
    sum += cursors[i].exchange(sum, std::memory_order_relaxed);
  }
  begins[cells] = sum;
  for_each_triangle(scene, [&](const Corners& triangle, u32 id) {
    for_each_cell(grid, triangle, config.insertion,
                  [&](u32 cell) { ids[cursors[cell].fetch_add(1, std::memory_order_relaxed)] = id; });
  });
  tbb::parallel_for(tbb::blocked_range<u64>(0, cells, 4096), [&](const tbb::blocked_range<u64>& range) {
    for (u64 i = range.begin(); i < range.end(); ++i) std::sort(&ids[0] + begins[i], &ids[0] + begins[i + 1]);
  });
  write_transforms(scene, slice_of(result.blob, grid.transforms));

  BuildStats& stats = result.stats;
  stats.nodes = stats.leaves = cells;
  stats.references = references;
  stats.size_bytes = result.blob.size_bytes();
  std::copy(grid.resolution, grid.resolution + 3, stats.resolution);
  stats.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace raywalk::grid
