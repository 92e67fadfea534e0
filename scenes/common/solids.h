// Building blocks of furnished scenes: boxes, turned shapes, balls and cushions as pieces with their share of
// triangles.
#pragma once
#include <vector>

#include "scenes/common/surface.h"

namespace raywalk {

/// A turn around the y axis, then a shift.
struct Placement {
  Vec3 origin{};
  float cosine = 1.0f, sine = 0.0f;

  static Placement at(Vec3 origin, double turns = 0.0);
  Vec3 direction(Vec3 v) const { return {cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x}; }
  Vec3 point(Vec3 p) const { return origin + direction(p); }
  /// The same for something that is placed inside this.
  Placement inner(Vec3 inner_origin, double turns = 0.0) const;
};

struct ProfilePoint {
  float radius, height;
};

// `density` is the share of triangles a square metre; densities only matter relative to each other.

/// Seen from the side where edge_u x edge_v points.
void add_quad(Pieces& pieces, Vec3 corner, Vec3 edge_u, Vec3 edge_v, u32 material, double density);
void add_box(Pieces& pieces, const Placement& place, Vec3 lo, Vec3 hi, u32 material, double density);
/// A smooth profile turned around the y axis: outside on the right when the profile goes up.
void add_turned(Pieces& pieces, const Placement& place, const std::vector<ProfilePoint>& profile, u32 material,
                double density);
void add_sphere(Pieces& pieces, Vec3 centre, float radius, u32 material, double density);
/// A box with well-rounded edges.
void add_cushion(Pieces& pieces, const Placement& place, Vec3 centre, Vec3 half, u32 material, double density);

}  // namespace raywalk
