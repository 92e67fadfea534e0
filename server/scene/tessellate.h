// Curved primitives as triangles, in the counts that the formats' rules give them.
#pragma once
#include <functional>
#include <glm/vec3.hpp>

#include "kernels/platform.h"

namespace raywalk {

/// A point of a curved surface and the unit normal there, in the primitive's own space.
struct SurfaceSample {
  glm::dvec3 position;
  glm::dvec3 normal;
};

/// Takes the three corners of a triangle, counter-clockwise seen from where the normals point.
using EmitTriangle = std::function<void(const SurfaceSample&, const SurfaceSample&, const SurfaceSample&)>;

// A negative radius turns the normals inwards. All angles start in a direction that depends on the axis alone, so that
// equal rims of neighbouring primitives on one axis meet without gaps.

/// An open cone between two rims, or a cylinder: 2 * slices triangles, or `slices` if one radius is 0.
void tessellate_cone(glm::dvec3 base, double base_radius, glm::dvec3 tip, double tip_radius, u32 slices,
                     const EmitTriangle& emit);
/// A flat ring, or a disc if `inner_radius` is 0: 2 * slices, or `slices` triangles.
void tessellate_ring(glm::dvec3 centre, glm::dvec3 normal, double inner_radius, double outer_radius, u32 slices,
                     const EmitTriangle& emit);
/// 2 * slices * (stacks - 1) triangles; the poles are on the z axis.
void tessellate_sphere(glm::dvec3 centre, double radius, u32 slices, u32 stacks, const EmitTriangle& emit);
/// 2 * slices * stacks triangles; the tube lies between the two radii around the axis `normal`.
void tessellate_torus(glm::dvec3 centre, glm::dvec3 normal, double inner_radius, double outer_radius, u32 slices,
                      u32 stacks, const EmitTriangle& emit);

}  // namespace raywalk
