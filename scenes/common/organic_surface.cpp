// Radius over direction: three merged bulbs, twisted lobes, ridges as of a brain coral, grain.
#include "scenes/common/organic_surface.h"

#include <cmath>

#include "scenes/common/exact_math.h"
#include "scenes/common/noise.h"

namespace raywalk {
namespace {

/// Distance from the origin to the far side of a sphere that contains the origin.
float far_side(Vec3 direction, Vec3 centre, float radius) {
  const float along = dot(direction, centre);
  return along + square_root(along * along - dot(centre, centre) + radius * radius);
}

/// The larger of the two, rounded off where they are closer than `width`.
float smooth_larger(float a, float b, float width) {
  const float h = larger(0.0f, width - magnitude(a - b)) / width;
  return larger(a, b) + 0.25f * width * h * h;
}

float clamped(float x) {
  return smaller(larger(x, 0.0f), 1.0f);
}
float smooth_step(float lo, float hi, float x) {
  const float t = clamped((x - lo) / (hi - lo));
  return t * t * (3.0f - 2.0f * t);
}

float radius_at(Vec3 d) {
  float r = far_side(d, {0.0f, -0.12f, 0.0f}, 0.82f);
  r = smooth_larger(r, far_side(d, {0.12f, 0.50f, 0.05f}, 0.60f), 0.35f);
  r = smooth_larger(r, far_side(d, {0.34f, 0.66f, 0.12f}, 0.78f) - 0.20f, 0.30f);

  // Seven lobes that wind around the axis; cos(7 * angle) as a power of a complex number needs no arc tangent.
  const float waist = square_root(d.x * d.x + d.z * d.z);
  const float twist = 0.16f * d.y;
  const float ct = static_cast<float>(cosine_turns(twist)), st = static_cast<float>(sine_turns(twist));
  const float inverse = waist > 1e-6f ? 1.0f / waist : 0.0f;
  const float x = (d.x * ct - d.z * st) * inverse, z = (d.x * st + d.z * ct) * inverse;
  float re = 1.0f, im = 0.0f;
  for (int i = 0; i < 7; ++i) {
    const float next = re * x - im * z;
    im = re * z + im * x;
    re = next;
  }
  const float lobes = smooth_step(0.15f, 0.75f, waist) * smooth_step(-1.0f, -0.2f, -d.y);
  r *= 1.0f + 0.075f * lobes * (re - 0.4f * re * re);

  // Ridges along the level lines of a warped noise.
  const Vec3 p = r * d;
  const Vec3 warp = {noise(1.7f * p + Vec3{3.1f, 0.0f, 0.0f}), noise(1.7f * p + Vec3{0.0f, 7.7f, 0.0f}),
                     noise(1.7f * p + Vec3{0.0f, 0.0f, 5.3f})};
  const float level = noise(2.6f * p + 0.9f * warp);
  const float wave = static_cast<float>(sine_turns(2.6f * level));
  const float ridge = 1.0f - square_root(wave * wave + 0.04f);
  const float where = smooth_step(-0.15f, 0.35f, noise(1.1f * p + Vec3{9.0f, 2.0f, 4.0f}) + 0.25f);
  const float grain = fractal_noise(22.0f * p, 3);
  return r + 0.045f * where * ridge + 0.0045f * grain + 0.02f * fractal_noise(4.0f * p, 2);
}

}  // namespace

SurfacePoint organic_surface(Vec3 direction, float spacing) {
  const float step = 0.5f * spacing;
  const Vec3 other = magnitude(direction.y) < 0.9f ? Vec3{0.0f, 1.0f, 0.0f} : Vec3{1.0f, 0.0f, 0.0f};
  const Vec3 u = normalized(cross(other, direction));
  const Vec3 v = cross(direction, u);
  const auto at = [](Vec3 d) { return radius_at(d) * d; };
  const Vec3 along_u = at(normalized(direction + step * u)) - at(normalized(direction - step * u));
  const Vec3 along_v = at(normalized(direction + step * v)) - at(normalized(direction - step * v));
  return {at(direction), normalized(cross(along_u, along_v))};
}

}  // namespace raywalk
