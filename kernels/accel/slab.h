// Bounds of a ray against boxes: conservative, one fused multiply-add a plane.
#pragma once
#include "kernels/ray.h"

namespace raywalk {

/// A plane p of a box, relative to the scene's centre, is crossed at fma(p, inverse, near) when it faces the ray's
/// origin, at fma(p, inverse, far) when it is the opposite one.
///
/// The box behaves as if it were padded by r * 2^-19 on every side, where r bounds the distance from the origin to any
/// vertex along any axis. In units of r * 2^-24 that is 32; the watertight triangle test may misplace a hit by 20
/// (translation and shear 5, edge functions 6, distance 9) and the slab test a plane by 6, so a box is never missed
/// whose triangle is hit, and its entry distance is never beyond that hit's t. Padding the box once a ray replaces the
/// enlarged far plane of Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013.
struct SlabRay {
  Vec3 inverse, near, far;
};

namespace detail {

/// An axis along which distances t would overflow or lose precision is left out: every box spans it.
RW_FN void slab_axis(float o, float d, float smallest_d, float reach, float& inverse, float& near, float& far) {
  const u32 sign = bits_of(d) & 0x80000000u;
  inverse = reciprocal(float_of(bits_of(larger(magnitude(d), smallest_d)) | sign));
  const float span = reach * magnitude(inverse);
  if (span > 0x1p-100f && span < 0x1p126f) {
    const float padding = float_of(bits_of(reach * 0x1p-19f) | sign);
    near = -(o + padding) * inverse;
    far = -(o - padding) * inverse;
  } else {
    inverse = 0.0f;
    near = -kMaxFloat;
    far = kMaxFloat;
  }
}

}  // namespace detail

/// `centre` and `half_extent` (the largest of the three) describe the bounds of the whole scene. A direction component
/// of zero becomes tiny, with its sign: across the scene that moves the ray by much less than the padding.
RW_FN SlabRay slab_ray(const Ray& ray, Vec3 centre, float half_extent) {
  const Vec3 o = ray.o - centre;
  const float reach = largest(magnitude(o)) + half_extent;
  const float smallest_d = largest(magnitude(ray.d)) * 0x1p-30f;
  SlabRay s;
  detail::slab_axis(o.x, ray.d.x, smallest_d, reach, s.inverse.x, s.near.x, s.far.x);
  detail::slab_axis(o.y, ray.d.y, smallest_d, reach, s.inverse.y, s.near.y, s.far.y);
  detail::slab_axis(o.z, ray.d.z, smallest_d, reach, s.inverse.z, s.near.z, s.far.z);
  return s;
}

/// Narrows [entry, exit] to the part of the ray inside the box (relative to the scene's centre); false when none is
/// left. Touching counts.
RW_FN bool clip(const SlabRay& s, Vec3 lo, Vec3 hi, float& entry, float& exit) {
  const bool px = !(bits_of(s.inverse.x) >> 31), py = !(bits_of(s.inverse.y) >> 31), pz = !(bits_of(s.inverse.z) >> 31);
  entry = larger(fma(px ? lo.x : hi.x, s.inverse.x, s.near.x), entry);
  entry = larger(fma(py ? lo.y : hi.y, s.inverse.y, s.near.y), entry);
  entry = larger(fma(pz ? lo.z : hi.z, s.inverse.z, s.near.z), entry);
  exit = smaller(fma(px ? hi.x : lo.x, s.inverse.x, s.far.x), exit);
  exit = smaller(fma(py ? hi.y : lo.y, s.inverse.y, s.far.y), exit);
  exit = smaller(fma(pz ? hi.z : lo.z, s.inverse.z, s.far.z), exit);
  return entry <= exit;
}

}  // namespace raywalk
