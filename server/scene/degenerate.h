// Triangles without an area.
#pragma once
#include "kernels/scene_view.h"

namespace raywalk {

/// True when the three vertices, which are finite, lie on one line or in one point, exactly. (To 113 bits: of triangles
/// whose coordinates differ in size by more than 2^32, some pass for proper ones.)
bool is_degenerate(const Corners& triangle);

}  // namespace raywalk
