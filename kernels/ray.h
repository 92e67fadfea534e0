// Rays and hits. A hit counts when tmin <= t <= tmax (closed interval); equal t goes to the lowest id.
#pragma once
#include "kernels/vec.h"

namespace raywalk {

constexpr u32 kMiss = 0xffffffffu;

/// 32 bytes, also the wire layout of POST /v1/rays. `d` need not be normalised; t is measured in lengths of d.
struct Ray {
  Vec3 o;
  float tmin;
  Vec3 d;
  float tmax;
};

/// 16 bytes, also the wire layout. A miss has id kMiss and t = tmax of its ray. u and v weigh the second and third
/// vertex.
struct Hit {
  float t;
  u32 id;
  float u, v;
};

/// False for NaN or infinity in any field and for the zero direction: such a ray misses everything.
RW_FN bool is_valid(const Ray& r) {
  const bool finite = is_finite(r.o) && is_finite(r.d) && is_finite(r.tmin) && is_finite(r.tmax);
  return finite && largest(magnitude(r.d)) > 0.0f;
}

RW_FN Hit miss_of(const Ray& r) {
  return {r.tmax, kMiss, 0.0f, 0.0f};
}

/// The order that makes a closest hit unique: smaller t first, then the lower id.
RW_FN bool closer(float t, u32 id, const Hit& than) {
  return t < than.t || (t == than.t && id < than.id);
}

}  // namespace raywalk
