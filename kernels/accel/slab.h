// Bounds of a ray against boxes: the ray-box tests that the knob `slab` chooses among.
#pragma once
#include "kernels/knobs.h"
#include "kernels/ray.h"

namespace raywalk {

/// Conservative: a box is never missed whose triangle the watertight test sees, and its entry distance is never beyond
/// that hit's t; at one fused multiply-add a plane.
///
/// With u = 2^-24 and D the largest distance (per axis) from the origin to a vertex of the triangle, that test may
/// misplace a hit by 20 u D: translation and shear 5, edge functions 6, distance 9. D is at most s + E, where s is the
/// distance to the hit (its largest component) and E the triangle's extent. So 32 u E are added to its bounds when the
/// tree is built (kTrianglePadding), and the ray is taken for a cone whose radius grows by 32 u a unit of s, which also
/// holds the relative rounding of the planes' distances; what is left is the rounding of the origin, 3 u of it.
/// Where the ray nearly runs along an axis's planes the cone would open to all of them: there, and for rays that reach
/// behind their origin, the box is padded by 32 u r, r at least the distance to any vertex of the scene.
struct PaddedSlab {
  static constexpr bool kPads = true;
  static constexpr bool kInfinities = false;
};
constexpr float kTrianglePadding = 0x1p-19f;  // of a triangle's largest extent; equals 32 u

/// As PaddedSlab without the padding: a box may be missed at its faces.
struct PlainSlab {
  static constexpr bool kPads = false;
  static constexpr bool kInfinities = false;
};

/// Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013: divisions by zero give infinities, a NaN (the origin in a plane
/// that the ray runs along) is dropped, and the far side is enlarged by the rounding of both. It never misses a box
/// that the exact ray meets; of what the triangle test sees beside the exact ray it knows nothing.
struct IzeSlab {
  static constexpr bool kPads = false;
  static constexpr bool kInfinities = true;
};

/// Where a ray crosses planes; see `crossing`. The planes that face the ray's origin have `inverse` and `near`, the
/// opposite ones `inverse_far` and `far`.
struct SlabRay {
  Vec3 inverse, inverse_far, near, far;
};

/// Distance to a plane p of a box, relative to the scene's centre.
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

struct SlabAxis {
  float inverse, inverse_far, near, far;
};

/// `d` is not zero. The origin is padded, and the direction is taken for anything between d - beam and d + beam, which
/// has d's sign. An axis along which distances t would overflow or lose precision is left out: every box spans it.
RW_FN SlabAxis slab_axis(float o, float d, float reach, float padding, float beam) {
  const float inverse = reciprocal(d);
  const float spread = beam * magnitude(inverse);
  const float span = reach * magnitude(inverse);
  if (!(span > 0x1p-100f && span < 0x1p125f)) return {0.0f, 0.0f, -kMaxFloat, kMaxFloat};
  SlabAxis axis{fma(-spread, inverse, inverse), fma(spread, inverse, inverse), 0, 0};
  const float outward = float_of(bits_of(padding) | (bits_of(d) & 0x80000000u));
  axis.near = -(o + outward) * axis.inverse;
  axis.far = -(o - outward) * axis.inverse_far;
  return axis;
}

}  // namespace detail

/// `centre` and `half_extent` (the largest of the three) describe the bounds of the whole scene. A direction component
/// of zero becomes tiny, with its sign: across the scene that moves the ray by much less than the padding. Ize's test
/// keeps it.
template <class Slab>
RW_FN SlabRay slab_ray(const Ray& ray, Vec3 centre, float half_extent) {
  const Vec3 o = ray.o - centre;
  if constexpr (Slab::kInfinities) {
    const Vec3 inverse{divide(1.0f, ray.d.x), divide(1.0f, ray.d.y), divide(1.0f, ray.d.z)};
    return {inverse, inverse, o, o};
  }
  const float reach = largest(magnitude(o)) + half_extent;
  const float main = largest(magnitude(ray.d));
  const float steep = ray.tmin >= 0.0f ? main * 0x1p-8f : kMaxFloat;
  const auto axis_of = [&](float origin, float component) {
    const float d = away_from_zero(component, main * 0x1p-30f);
    if constexpr (!Slab::kPads) return detail::slab_axis(origin, d, reach, 0.0f, 0.0f);
    const bool cone = magnitude(d) > steep;
    const float padding = cone ? magnitude(origin) * 0x1p-22f : reach * 0x1p-19f;
    // A little more than 32 u, since the inverse of d - beam is taken for (1 + beam / d) / d.
    return detail::slab_axis(origin, d, reach, padding, cone ? 0x1.01p-19f * main : 0.0f);
  };
  const detail::SlabAxis x = axis_of(o.x, ray.d.x), y = axis_of(o.y, ray.d.y), z = axis_of(o.z, ray.d.z);
  const Vec3 inverse{x.inverse, y.inverse, z.inverse};
  SlabRay s{inverse, inverse, {x.near, y.near, z.near}, {x.far, y.far, z.far}};
  if constexpr (Slab::kPads) s.inverse_far = {x.inverse_far, y.inverse_far, z.inverse_far};
  return s;
}

}  // namespace raywalk
