// The frame of the spatial structures (grid, kd-tree): coordinates relative to the scene's centre, triangles padded,
// and a ray moved to its entry into the padded box.
//
// Why padding makes a spatial structure exact. The triangle test rounds, so it may report a triangle that the exact
// line misses by a little. With u = 2^-24, h the largest half extent, and D the largest distance (per axis) from the
// origin to a vertex: v - o errs by u*D, and its shear by the slope adds 2*u*D and the rounding of the result (4*u*h);
// the signs of the edge functions are exact. So a reported line passes within 3*u*D + 4*u*h of the triangle. The
// traversal adds its own: o - centre (u*D), the moved origin and the distance to a plane (8*u*h), the rounding of the
// padded bounds and of the cell borders (6*u*h), the clamped direction (less than u*h).
// With kPad = 64*u*h all of it is covered for origins at most 8*h from the centre (D <= 9*h: 36 + 18 = 54 < 64).
// A farther origin makes a wide ray: it is traversed as a beam of radius 8*u*D, which exceeds 4*u*D + 18*u*h.
#pragma once
#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk {

constexpr float kPad = 0x1p-18f;         // of the largest half extent; equals 64 u
constexpr float kNearOrigin = 8.0f;      // largest half extents; farther origins make wide rays
constexpr float kWideRadius = 0x1p-21f;  // of the distance D; equals 8 u
// The reported t errs along the ray by up to 10*u*D + 12*u*h for the arithmetic and 8*u*D for a denormal reciprocal.
constexpr float kDistanceSlack = 0x1p-18f;  // of the distance D; equals 64 u
constexpr float kTinyHalf = 0x1p-60f;       // keeps pad and cells above zero when all triangles are points

/// Centre and half extents of all finite triangles.
struct PaddedFrame {
  Vec3 centre;
  float largest_half;
  Vec3 half;  // with pad: the padded triangles lie in [-half, half]
  float pad;
};

/// Of the bounds in a scene's header; an empty box gives a tiny frame at the origin.
RW_FN PaddedFrame padded_frame(const Box& bounds) {
  PaddedFrame frame{{0, 0, 0}, kTinyHalf, {0, 0, 0}, 0};
  if (!bounds.empty()) {
    frame.centre = bounds.centre();
    frame.half = larger(bounds.hi - frame.centre, frame.centre - bounds.lo);
    frame.largest_half = larger(largest(frame.half), kTinyHalf);
  }
  frame.pad = kPad * frame.largest_half;
  frame.half = frame.half + Vec3{frame.pad, frame.pad, frame.pad};
  return frame;
}

/// Bounds of a finite triangle in the frame, padded.
RW_FN Box padded_bounds(const PaddedFrame& frame, const Corners& triangle) {
  const Vec3 pad{frame.pad, frame.pad, frame.pad};
  const Box box = bounds_of(triangle);
  return {larger((box.lo - frame.centre) - pad, -frame.half), smaller((box.hi - frame.centre) + pad, frame.half)};
}

/// A ray in the frame. Its distances s run from its entry into the padded box: s = t * scale - shift.
struct LocalRay {
  Vec3 o;
  Vec3 d;        // the largest component is near 1, none is zero
  Vec3 inverse;  // 1 / d
  float exit;    // the ray leaves the box, or passes its tmax, at this s
  float radius;  // of the beam; 0 unless the ray is wide
  float scale, rest;

  RW_FN bool wide() const { return radius > 0.0f; }
  /// No hit that counts lies beyond the returned s, given the query's present tmax.
  RW_FN float limit(float tmax) const { return fma(tmax, scale, rest); }
};

/// The magnitude of `a`, which is not negative, with the sign of `b`.
RW_FN Vec3 with_signs(Vec3 a, Vec3 b) {
  return {float_of(bits_of(a.x) | (bits_of(b.x) & 0x80000000u)), float_of(bits_of(a.y) | (bits_of(b.y) & 0x80000000u)),
          float_of(bits_of(a.z) | (bits_of(b.z) & 0x80000000u))};
}

/// Moves a valid ray to its entry into the frame's box (enlarged by twice the padding, so that the rounding of the
/// entry cannot cut into it). False when the ray misses the box or its interval ends before.
RW_FN bool enter(const PaddedFrame& frame, const Ray& ray, LocalRay& local) {
  // Scaling by a power of two is exact and keeps every reciprocal finite for any direction.
  const i32 exponent = static_cast<i32>(bits_of(largest(magnitude(ray.d))) >> 23) - 127;
  const i32 clamped = exponent < -126 ? -126 : exponent > 126 ? 126 : exponent;
  local.scale = float_of(static_cast<u32>(127 + clamped) << 23);
  const Vec3 scaled = ray.d * float_of(static_cast<u32>(127 - clamped) << 23);
  local.d = away_from_zero(scaled, 0x1p-30f * largest(magnitude(scaled)));
  local.inverse = {reciprocal(local.d.x), reciprocal(local.d.y), reciprocal(local.d.z)};

  const Vec3 origin = ray.o - frame.centre;
  const float away = largest(magnitude(origin));
  const float distance = away + frame.largest_half;
  local.radius = away > kNearOrigin * frame.largest_half ? kWideRadius * distance : 0.0f;
  const float margin = 2.0f * larger(frame.pad, local.radius);
  const Vec3 side = with_signs(frame.half + Vec3{margin, margin, margin}, local.d);
  const Vec3 in = (-side - origin) * local.inverse;
  const Vec3 out = (side - origin) * local.inverse;

  // A huge direction makes t denormal, with an error of 2^-149. The product is taken in two normal steps.
  const float coarse = local.scale > 0x1p64f ? local.scale * 0x1p-64f * 0x1p-84f : 0.0f;
  const float slack = fma(kDistanceSlack, distance, coarse);
  const float start = larger(larger(in.x, larger(in.y, in.z)), fma(ray.tmin, local.scale, -slack));
  const float end = smaller(smaller(out.x, smaller(out.y, out.z)), fma(ray.tmax, local.scale, slack));
  local.o = fma(start, local.d, origin);
  local.exit = end - start;
  local.rest = slack - start;
  return start <= end && is_finite(local.o);
}

}  // namespace raywalk
