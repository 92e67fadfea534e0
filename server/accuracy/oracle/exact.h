// One ray and one triangle of float32 numbers in exact arithmetic: what a ray-triangle test should have said.
#pragma once
#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk::oracle {

/// A decision within this distance of the ray, times the largest component of a vertex seen from the origin, is near:
/// float32 arithmetic that rounds a few times may take it either way. 16 half ulps; the padding of the spatial
/// structures rests on less than 8.
constexpr double kNear = 0x1p-20;
/// Exact distances that differ by no more ulps than this are a tie.
constexpr double kTieUlps = 2.0;

/// Where the line of a ray, infinite on both sides, passes a triangle. Both windings are alike.
enum class Position : u8 {
  outside,   // misses it; so do all invalid rays, and all lines a non-finite triangle
  inside,    // meets its interior
  edge,      // meets an edge, but no vertex
  vertex,    // meets a vertex
  coplanar,  // lies in its plane, or touches a degenerate triangle: never a hit
};

constexpr bool is_met(Position p) {
  return p == Position::inside || p == Position::edge || p == Position::vertex;
}

/// Distances are measured in lengths of d.
struct Crossing {
  Position position = Position::outside;
  /// The line passes an edge within the near radius. Computed in double: within 1e-8 of the radius it may go either
  /// way. Never for a degenerate triangle.
  bool near = false;
  bool by_integers = false;  // the filter left something open
  double radius = 0;         // the near radius, a length
  /// Of the point where the line meets a triangle that is met, rounded once; infinite beyond the floats, never -0.
  float t = 0;
  /// The same with an error of at most 2^-12 ulp of a float.
  double precise_t = 0;
  /// A ray moved by at most the near radius, with its t rounded by up to 2 ulps, meets a triangle that is met or near
  /// between these.
  double low = 0, high = 0;

  bool met() const { return is_met(position); }
  bool touched() const { return met() || near; }
};

/// Any float, denormals and 1e38 included. Signs are exact: a filter in double decides nearly all, integers the rest.
Crossing classify(const Ray& ray, const Corners& triangle);

/// -1, 0 or 1: the order of the exact distances to two triangles that are both met. A kernel compares rounded ones.
int compare_distances(const Ray& ray, const Corners& a, const Corners& b);
/// -1, 0 or 1: the order of the exact distance to a triangle that is met, and a finite `bound` such as tmin.
int compare_distance(const Ray& ray, const Corners& triangle, float bound);

/// The distance between neighbouring floats at t, as if their exponents had no upper end.
double ulp_at(double t);

}  // namespace raywalk::oracle
