// Splitting a mesh to a given number of triangles without changing its shape.
#pragma once
#include "server/scene/scene.h"

namespace raywalk {

/// Halves the longest edge, again and again, with the triangles on both its sides, until there are exactly `triangles`.
/// Edges are the same when their ends have the same positions, so no crack opens; normals and texture coordinates are
/// halved too. Edges of more than two triangles stay, and with them the shorter edges of their triangles. The same bits
/// everywhere.
/// Throws std::invalid_argument if there are more triangles already, or if that number cannot be reached (a closed mesh
/// gains two a step).
void split_edges(Scene& scene, u64 triangles);

}  // namespace raywalk
