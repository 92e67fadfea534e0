// Bounds of a ray against boxes: the ray-box tests that the knob `slab` chooses among.
#pragma once
#include "kernels/knobs.h"
#include "kernels/ray.h"

namespace raywalk {

/// Conservative, one fused multiply-add a plane. The box behaves as if it were padded by r * 2^-19 on every side, where
/// r bounds the distance from the origin to any vertex along any axis. In units of r * 2^-24 that is 32; the watertight
/// triangle test may misplace a hit by 20 (translation and shear 5, edge functions 6, distance 9) and the slab test a
/// plane by 6, so a box is never missed whose triangle is hit, and its entry distance is never beyond that hit's t.
struct PaddedSlab {
  static constexpr float kPadding = 0x1p-19f;  // of r
  static constexpr bool kInfinities = false;
};

/// As PaddedSlab without the padding: a box may be missed at its faces.
struct PlainSlab {
  static constexpr float kPadding = 0.0f;
  static constexpr bool kInfinities = false;
};

/// Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013: divisions by zero give infinities, a NaN (the origin in a plane
/// that the ray runs along) is dropped, and the far side is enlarged by the rounding of both. It never misses a box
/// that the exact ray meets; of what the triangle test sees beside the exact ray it knows nothing.
struct IzeSlab {
  static constexpr float kPadding = 0.0f;
  static constexpr bool kInfinities = true;
};

/// Where a ray crosses planes; see `crossing`.
struct SlabRay {
  Vec3 inverse, near, far;
};

/// Distance to a plane p of a box, relative to the scene's centre. `offset` is SlabRay::near for a plane that faces the
/// ray's origin, SlabRay::far for the opposite one.
template <class Slab>
RW_FN float crossing(float p, float inverse, float offset) {
  if constexpr (Slab::kInfinities) return (p - offset) * inverse;
  return fma(p, inverse, offset);
}

/// The exit distance from a box as it is compared with the entry distance.
template <class Slab>
RW_FN float widened(float exit) {
  if constexpr (Slab::kInfinities) return exit * 1.00000024f;
  return exit;
}

namespace detail {

/// An axis along which distances t would overflow or lose precision is left out: every box spans it.
template <class Slab>
RW_FN void slab_axis(float o, float d, float smallest_d, float reach, float& inverse, float& near, float& far) {
  if constexpr (Slab::kInfinities) {
    inverse = divide(1.0f, d);
    near = far = o;
    return;
  }
  const u32 sign = bits_of(d) & 0x80000000u;
  inverse = reciprocal(float_of(bits_of(larger(magnitude(d), smallest_d)) | sign));
  const float span = reach * magnitude(inverse);
  if (span > 0x1p-100f && span < 0x1p126f) {
    const float padding = float_of(bits_of(reach * Slab::kPadding) | sign);
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
template <class Slab>
RW_FN SlabRay slab_ray(const Ray& ray, Vec3 centre, float half_extent) {
  const Vec3 o = ray.o - centre;
  const float reach = largest(magnitude(o)) + half_extent;
  const float smallest_d = largest(magnitude(ray.d)) * 0x1p-30f;
  SlabRay s;
  detail::slab_axis<Slab>(o.x, ray.d.x, smallest_d, reach, s.inverse.x, s.near.x, s.far.x);
  detail::slab_axis<Slab>(o.y, ray.d.y, smallest_d, reach, s.inverse.y, s.near.y, s.far.y);
  detail::slab_axis<Slab>(o.z, ray.d.z, smallest_d, reach, s.inverse.z, s.near.z, s.far.z);
  return s;
}

}  // namespace raywalk
