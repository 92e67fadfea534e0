// Whether a surface has no gap beside a ray.
#pragma once
#include "server/accuracy/oracle/beam_tree.h"

namespace raywalk::oracle {

/// True when every ray parallel to the given one and within `radius` of it meets the triangle `id`, or one that is
/// joined to it there: by an edge or vertex that passes within two radii, and so on. Only triangles clearly before the
/// distance `end` count: another ray may meet what stands there first. Seen along the ray, both sides of every edge
/// within the radius must be covered, and across it a triangle must have the same edge: so silhouettes are no seals,
/// and neither are T-junctions and pieces that only overlap, which rounded vertices leave open however exact the rest
/// is. The ray must be valid and meet the triangle.
bool is_sealed(const Ray& ray, u32 id, double radius, double end, SceneView scene, const BeamTree& tree);

}  // namespace raywalk::oracle
