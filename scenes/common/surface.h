// Surfaces that are tessellated into exactly as many triangles as asked for.
#pragma once
#include <functional>
#include <vector>

#include "server/scene/triangle_sink.h"

namespace raywalk {

struct SurfacePoint {
  Vec3 position;
  Vec3 normal;  // unit length, outwards
};

/// A surface over the unit square. Triangles turn left when the normal points at the viewer if d/du x d/dv does.
using PatchShape = std::function<SurfacePoint(float u, float v)>;
/// A closed surface around the origin's directions: `spacing` is the angle in radians between neighbouring samples.
using BallShape = std::function<SurfacePoint(Vec3 direction, float spacing)>;

constexpr u64 kLeastPatchTriangles = 2;
constexpr u64 kLeastBallTriangles = 80;

/// Exactly `triangles` (at least kLeastPatchTriangles); `aspect` is the length along u over that along v.
void add_patch(TriangleSink& sink, const PatchShape& shape, float aspect, u32 material, u64 triangles);

/// Exactly `triangles` (even, at least kLeastBallTriangles) without a gap: every edge has two triangles.
void add_ball(TriangleSink& sink, const BallShape& shape, u32 material, u64 triangles);

/// Pieces of a scene that share a number of triangles by their weights.
class Pieces {
 public:
  /// Has at least `least` triangles, whatever the weights give it.
  void patch(PatchShape shape, float aspect, u32 material, double weight, u64 least = kLeastPatchTriangles);
  void ball(BallShape shape, u32 material, double weight);
  void append(const Pieces& other);
  /// Fewest triangles that add_to can give.
  u64 least_triangles() const;
  /// Pours exactly `triangles`, vertices and triangles in one fixed order; begin() is the caller's.
  /// There must be at least one patch. Throws std::invalid_argument below least_triangles().
  void add_to(TriangleSink& sink, u64 triangles) const;

 private:
  struct Piece {
    PatchShape patch;
    BallShape ball;
    float aspect;
    u32 material;
    double weight;
    u64 least;
  };
  std::vector<Piece> pieces_;
};

}  // namespace raywalk
