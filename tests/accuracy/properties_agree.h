// When two answers to the same question, put in two ways, agree.
#pragma once
#include <string_view>

#include "server/accuracy/cases/meshes.h"

namespace raywalk::accuracy {

/// An answer with its question. The ids of the mesh are those of the shape, `hit.id` is a place in the mesh.
struct Answered {
  const Ray& ray;
  const Mesh& mesh;
  Hit hit;

  bool is_hit() const { return hit.id != kMiss; }
  const Corners& triangle() const { return mesh[hit.id]; }
  u32 id() const { return is_hit() ? triangle().id : kMiss; }
};

/// But for the signs of zeros.
bool same_numbers(const Hit& a, const Hit& b);

/// The axis along which the watertight test shears.
u32 main_axis(Vec3 d);

/// The same triangle or none, and t, u and v as far apart as a strict test's rounding may put them.
bool same_up_to_rounding(std::string_view intersector, const Answered& before, const Answered& after);

/// Of strict tests: where the nearer of both hits lies on an edge or vertex, that may have another owner now. A sealed
/// surface is then met in a triangle beside it, at the same place.
bool new_owner(std::string_view intersector, const Answered& before, const Answered& after, bool sealed);

}  // namespace raywalk::accuracy
