// Phong's local model and the directions of mirror and glass.
#pragma once
#include "kernels/scene_view.h"
#include "kernels/shade/power.h"

namespace raywalk {

RW_FN Vec3 reflected(Vec3 d, Vec3 n) {
  return fma(-2.0f * dot(d, n), n, d);
}

/// Direction of the refracted ray; false on total reflection. `n` faces against the unit direction `d`; `eta` is the
/// index of the medium that the ray leaves over the one that it enters.
RW_FN bool refracted(Vec3 d, Vec3 n, float eta, Vec3& out) {
  if (eta == 1.0f) {  // straight on, to the bit
    out = d;
    return true;
  }
  const float cosine = -dot(d, n);
  const float k = fma(-eta * eta, fma(-cosine, cosine, 1.0f), 1.0f);
  if (k < 0.0f) return false;
  out = normalized(fma(eta, d, n * fma(eta, cosine, -square_root(k))));
  return true;
}

/// The part of a material that the local model reads.
struct PhongTerms {
  Vec3 diffuse, specular;
  float shininess;
};

/// Light of one visible lamp, without a branch. `n` is on the viewer's side of the surface, `to_light` and `d` (the ray
/// that came) are unit vectors.
template <bool kSpecular>
RW_FN Vec3 phong(const PhongTerms& m, Vec3 intensity, Vec3 n, Vec3 to_light, Vec3 d) {
  const float cosine = dot(n, to_light);
  Vec3 sum = m.diffuse * cosine;
  if (kSpecular) {
    const float highlight = dot(reflected(d, n), to_light);
    sum = fma(power(smaller(larger(highlight, 0.0f), 1.0f), m.shininess), m.specular, sum);
  }
  return sum * intensity * (cosine > 0.0f ? 1.0f : 0.0f);
}

}  // namespace raywalk
