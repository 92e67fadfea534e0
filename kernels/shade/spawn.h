// Where a ray starts that leaves a surface, so that it does not meet the surface again: the knob `spawn`.
#pragma once
#include "kernels/knobs.h"
#include "kernels/shade/surface.h"

namespace raywalk {

namespace detail {

/// The geometric normal on the side to which `d` leaves.
RW_FN Vec3 normal_towards(const Surface& s, Vec3 d) {
  return dot(d, s.geometric_normal) > 0.0f ? s.geometric_normal : -s.geometric_normal;
}

}  // namespace detail

/// Along the normal past the error of the position (Pharr et al., PBR 3.9.5) and that of the triangle test, and then
/// outward by the last bit: the watertight test never meets the surface again. Both are taken more than twice, so that
/// the ray begins outside the padding of its leaf's box (kernels/accel/slab.h) where the surface is flat.
struct ErrorBoundOffset {
  RW_FN static Vec3 origin(const Surface& s, Vec3 d) {
    const Vec3 n = detail::normal_towards(s, d);
    const Vec3 p = fma(fma(3.0f, dot(magnitude(n), s.error), 2.4f * s.slack), n, s.position);
    const auto away = [](float value, float direction) {
      if (direction == 0.0f || value == 0.0f) return value;
      return float_of(bits_of(value) + ((value > 0.0f) == (direction > 0.0f) ? 1u : 0xffffffffu));
    };
    return {away(p.x, n.x), away(p.y, n.y), away(p.z, n.z)};
  }
};

/// Each coordinate by up to 256 of its own ulps, near zero by 2^-16: Waechter and Binder, "A Fast and Robust Method for
/// Avoiding Self-Intersection", Ray Tracing Gems, 2019. The step does not know the triangle's size.
struct IntegerOffset {
  RW_FN static Vec3 origin(const Surface& s, Vec3 d) {
    const Vec3 n = detail::normal_towards(s, d);
    const auto moved = [](float p, float direction) {
      if (magnitude(p) < 1.0f / 32.0f) return fma(direction, 0x1p-16f, p);
      const i32 ulps = static_cast<i32>(256.0f * direction);
      return float_of(bits_of(p) + static_cast<u32>(p < 0.0f ? -ulps : ulps));
    };
    return {moved(s.position.x, n.x), moved(s.position.y, n.y), moved(s.position.z, n.z)};
  }
};

struct ConstantOffset {
  RW_FN static Vec3 origin(const Surface& s, Vec3 d) { return fma(1e-4f, detail::normal_towards(s, d), s.position); }
};

struct NoOffset {
  RW_FN static Vec3 origin(const Surface& s, Vec3 /*d*/) { return s.position; }
};

}  // namespace raywalk
