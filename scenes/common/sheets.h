// Surfaces with a chosen number of cells: sheets by formula, rounded boxes, turned shapes, tubes and slabs.
// A piece of columns x rows cells weighs as many triangles: the numbers come out as chosen where all weights add up to
// the triangles asked for, and in proportion otherwise.
#pragma once
#include <functional>
#include <vector>

#include "scenes/common/solids.h"

namespace raywalk {

/// A point for (u, v) in the unit square; the front is where d/du x d/dv points.
using PointShape = std::function<Vec3(float u, float v)>;

struct Cells {
  u32 columns, rows;  // along u and v
};

/// Smooth normals from differences of half a cell.
void add_sheet(Pieces& pieces, const PointShape& shape, Cells cells, u32 material);

enum class Ends { closed, open };

/// A box of half extents `half` whose edges are rounded with radius `round`, by `arc` chords each:
/// 8 (arc + 1) (2 arc + 3) triangles, or 8 (arc + 1) (2 arc + 1) where the flat ends along x are left out.
void add_pad(Pieces& pieces, const Placement& place, Vec3 centre, Vec3 half, float round, u32 material, u32 arc = 1,
             Ends ends = Ends::closed);

/// A polygonal profile around the y axis: outside on the right when the profile goes up. Two triangles for each side
/// of each segment.
void add_lathe(Pieces& pieces, const Placement& place, const std::vector<ProfilePoint>& profile, u32 sides,
               u32 material);

/// The smooth curve through the points, t in [0, 1]; uniform in the points' numbers.
Vec3 curve_at(const std::vector<Vec3>& points, float t);

/// An open tube around the smooth curve through the points, in the place's coordinates.
void add_tube(Pieces& pieces, const Placement& place, const std::vector<Vec3>& points, float radius, Cells cells,
              u32 material);

/// A flat body between y = bottom and y = top: `outline` gives its rim in the plane y = 0 for t in [0, 1], closed and
/// turning left seen from above; every point of the rim is seen from `middle`. 6 triangles a chord.
void add_slab(Pieces& pieces, const Placement& place, const std::function<Vec3(float t)>& outline, Vec3 middle,
              float bottom, float top, u32 chords, u32 material);

/// A box of twelve triangles.
void add_block(Pieces& pieces, const Placement& place, Vec3 lo, Vec3 hi, u32 material);
/// Two triangles, seen from the side where edge_u x edge_v points.
void add_plate(Pieces& pieces, Vec3 corner, Vec3 edge_u, Vec3 edge_v, u32 material);

}  // namespace raywalk
