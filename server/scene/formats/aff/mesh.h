// The statement `m`: a mesh whose corners index points, normals and texture coordinates apart.
#pragma once
#include "server/scene/formats/aff/geometry.h"
#include "server/scene/formats/aff/materials.h"

namespace raywalk::aff {

/// Reads what follows the word. Throws std::runtime_error.
void read_mesh(Text& text, Geometry& geometry, Materials& materials);

}  // namespace raywalk::aff
