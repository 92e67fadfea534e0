// The organic object's surface: a pear-shaped body under spirals of scales, with fine grain.
#pragma once
#include "scenes/common/surface.h"

namespace raywalk {

/// The point of the surface in the given direction from its core, about one unit away; the normal is sampled at
/// `spacing` radians.
SurfacePoint organic_surface(Vec3 direction, float spacing);

}  // namespace raywalk
