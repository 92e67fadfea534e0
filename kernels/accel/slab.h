// Bounds of a ray against boxes: the ray-box tests that the knob `slab` chooses among.
#pragma once
#include "kernels/float4.h"
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

/// Where a ray crosses planes, by axis; see `crossing`. The planes that face the ray's origin have `inverse` and
/// `near`, the opposite ones `inverse_far` and `far`. On the host the axes share a register.
template <class T>
struct SlabAxes {
  T inverse, inverse_far, near, far;
};
#if RW_GPU
using SlabRay = SlabAxes<Vec3>;
#else
using SlabRay = SlabAxes<Float4>;
#endif

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

/// What a ray has in common along all axes.
struct SlabScale {
  float main;   // the largest component of its direction
  float reach;  // at least the distance to any vertex of the scene
  float steep;  // of a direction's component: above it, padding is a cone
};

/// T is one axis, as on the GPU, or all of them in a register. A direction component of zero becomes tiny, with its
/// sign: across the scene that moves the ray by much less than the padding. An axis along which distances t would
/// overflow or lose precision is left out: every box spans it.
template <class Slab, class T>
RW_FN SlabAxes<T> slab_axes(T o, T component, const SlabScale& scale) {
  const T d = with_sign_of(larger(magnitude(component), splat<T>(scale.main * 0x1p-30f)), component);
  // The origin is padded, and the direction is taken for anything between d - beam and d + beam, which has d's sign.
  // The beam is a little more than 32 u, since the inverse of d - beam is taken for (1 + beam / d) / d.
  const auto cone = magnitude(d) > splat<T>(scale.steep);
  const T padding = cone ? magnitude(o) * 0x1p-22f : splat<T>(scale.reach * 0x1p-19f);
  const T beam = cone ? splat<T>(0x1.01p-19f * scale.main) : splat<T>(0.0f);
  const T inverse = reciprocal(d);
  const T spread = beam * magnitude(inverse);
  const T span = scale.reach * magnitude(inverse);
  const auto counts = (span > splat<T>(0x1p-100f)) & (span < splat<T>(0x1p125f));
  const SlabAxes<T> spanned{splat<T>(0.0f), splat<T>(0.0f), splat<T>(-kMaxFloat), splat<T>(kMaxFloat)};
#if RW_GPU
  if (!counts) return spanned;
#endif
  SlabAxes<T> s{inverse, inverse, -o * inverse, -o * inverse};
  if constexpr (Slab::kPads) {
    s.inverse = fma(-spread, inverse, inverse);
    s.inverse_far = fma(spread, inverse, inverse);
    const T outward = with_sign_of(padding, d);
    s.near = -(o + outward) * s.inverse;
    s.far = -(o - outward) * s.inverse_far;
  }
#if RW_GPU
  return s;
#else
  return {counts ? s.inverse : spanned.inverse, counts ? s.inverse_far : spanned.inverse_far,
          counts ? s.near : spanned.near, counts ? s.far : spanned.far};
#endif
}

}  // namespace detail

/// `centre` and `half_extent` (the largest of the three) describe the bounds of the whole scene.
template <class Slab>
RW_FN SlabRay slab_ray(const Ray& ray, Vec3 centre, float half_extent) {
  const Vec3 o = ray.o - centre;
  const float main = largest(magnitude(ray.d));
  const detail::SlabScale scale{main, largest(magnitude(o)) + half_extent,
                                ray.tmin >= 0.0f ? main * 0x1p-8f : kMaxFloat};
#if RW_GPU
  if constexpr (Slab::kInfinities) {
    const Vec3 inverse{divide(1.0f, ray.d.x), divide(1.0f, ray.d.y), divide(1.0f, ray.d.z)};
    return {inverse, inverse, o, o};
  }
  const auto x = detail::slab_axes<Slab>(o.x, ray.d.x, scale), y = detail::slab_axes<Slab>(o.y, ray.d.y, scale),
             z = detail::slab_axes<Slab>(o.z, ray.d.z, scale);
  return {{x.inverse, y.inverse, z.inverse},
          {x.inverse_far, y.inverse_far, z.inverse_far},
          {x.near, y.near, z.near},
          {x.far, y.far, z.far}};
#else
  const Float4 origin{o.x, o.y, o.z, 0.0f}, d{ray.d.x, ray.d.y, ray.d.z, 0.0f};
  if constexpr (Slab::kInfinities) {
    const Float4 inverse = reciprocal(d);
    return {inverse, inverse, origin, origin};
  }
  return detail::slab_axes<Slab>(origin, d, scale);
#endif
}

}  // namespace raywalk
