// Closed meshes at many sizes and places, seen from inside.
#pragma once
#include "server/accuracy/cases/trial.h"

namespace raywalk::accuracy {

/// A closed mesh and points inside. From each of them every direction meets the mesh exactly once, with a margin that
/// float32 arithmetic cannot use up. There is no such point where rounding has folded the mesh.
struct Placed {
  std::string name;
  Mesh mesh;
  SceneBlob scene;
  std::vector<Vec3> inside;
  Vec3 centre;
};

/// Points of `candidates` that see all triangles from inside. Triangles are wound outward.
std::vector<Vec3> seeing_all(const Mesh& mesh, const std::vector<Vec3>& candidates);

/// The mesh, scaled and then moved by (1, -1, 1/2) times the offset; its points inside lie within `room` of the origin
/// before.
Placed placed(std::string name, const Mesh& mesh, float scale, float offset, float room, Random random);

/// Six meshes at scales 1e-6 to 1e6 and offsets 0 to 1e6, the latter up to 1e6 times the scale: beyond that the floats
/// hold no shape.
std::vector<Placed> placed_meshes(Random random);

/// 16 x 16 facets around the y axis, each vertex 1 to 6 away from the origin.
Mesh spiky_mesh(Random random);

/// From a point inside to a point on an edge of a triangle, or to a vertex; the next of the four points (or three)
/// that `place` numbers.
Ray ray_to_edge(Vec3 from, const Corners& triangle, u32 place, float along);
Ray ray_to_vertex(Vec3 from, const Corners& triangle, u32 place);

}  // namespace raywalk::accuracy
