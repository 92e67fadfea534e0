// Shapes along a line or a curve in any direction: tubes, rings and slabs.
#pragma once
#include <vector>

#include "scenes/common/surface.h"

namespace raywalk {

// All are round enough to be seen as what they are, however few triangles there are.

struct TubePoint {
  Vec3 at;
  float radius;
};

/// A smooth tube through at least two points, open at its ends: let the radius go to almost nothing to close it. The
/// points must not turn through all three axes. `density` is the share of triangles a square metre.
void add_tube(Pieces& pieces, const std::vector<TubePoint>& points, u32 material, double density);
/// A straight rod, closed at both ends.
void add_rod(Pieces& pieces, Vec3 from, Vec3 to, float radius, u32 material, double density);
/// A torus around `axis`, which has unit length.
void add_ring(Pieces& pieces, Vec3 centre, Vec3 axis, float radius, float thickness, u32 material, double density);
/// A box in any direction; the half edges are at right angles and turn right-handed.
void add_slab(Pieces& pieces, Vec3 centre, Vec3 half_x, Vec3 half_y, Vec3 half_z, u32 material, double density);
/// A flat disc that is seen from where `axis` (unit length) points.
void add_disc(Pieces& pieces, Vec3 centre, Vec3 axis, float radius, u32 material, double density);

/// Two unit vectors at right angles to `axis` and to each other: first x second = axis.
struct Across {
  Vec3 first, second;
};
Across across(Vec3 axis);

}  // namespace raywalk
