// Host only: builds the uniform grid.
#pragma once
#include "kernels/accel/kind.h"

namespace raywalk::grid {

/// How a triangle chooses its cells: those its bounds overlap, or those the triangle itself overlaps.
enum class Insertion { kBounds, kExact };

struct Config {
  u32 resolution[3] = {0, 0, 0};  // cells along each axis; 0 is chosen by density
  double density = 6.15;          // cells a triangle; gives the study's grid for its bunny, 83 x 82 x 64
  Insertion insertion = Insertion::kBounds;
  TriangleRecords triangles = TriangleRecords::corners;
};

constexpr u32 kMaxResolution = 16384;    // along one axis
constexpr u64 kMaxCells = u64{1} << 28;  // 1 GiB of cell offsets
// A grid by density has at most this many overlaps a triangle, and some for small scenes.
constexpr u64 kCandidatesATriangle = 64, kFreeCandidates = u64{1} << 24;
constexpr u64 kMaxCandidates = u64{1} << 30;  // overlaps of triangle bounds and cells: 4 GiB of references
constexpr u64 kMaxCellsByDensity = u64{1} << 26;

/// Memory beside the blob: 4 bytes a cell. Throws std::invalid_argument when the limits above are exceeded.
BuiltStructure build(SceneView scene, const Config& config);

}  // namespace raywalk::grid
