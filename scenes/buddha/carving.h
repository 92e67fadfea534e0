// Carving: surfaces that are found by going inwards until a field of distances says that the stone begins.
#pragma once
#include <functional>

#include "scenes/common/surface.h"

namespace raywalk::buddha {

/// Distance to the surface, negative inside; never much more than the true one.
using Field = std::function<float(Vec3 p)>;

/// From a point to a rod between a and b whose ends are round.
float to_rod(Vec3 p, Vec3 a, Vec3 b, float radius_a, float radius_b);
/// To a ball that is stretched by `half`.
float to_ellipsoid(Vec3 p, Vec3 centre, Vec3 half);
/// Both together, the seam filled over about `width`.
float merged(float a, float b, float width);
/// 0 below lo, 1 above hi, smooth between.
float ramp(float lo, float hi, float x);

/// The outermost surface of the field on each ray from `centre`; `half` is about its size in each direction, and
/// spreads the rays so that triangles come out evenly.
void add_carved(Pieces& pieces, Vec3 centre, Vec3 half, Field field, u32 material, double density);

}  // namespace raywalk::buddha
