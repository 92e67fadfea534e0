// Radius over direction: two merged bulbs under spirals of scales, with ridges and grain.
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

struct Angle {
  float cosine, sine;
};
Angle turned(double turns) {
  return {static_cast<float>(cosine_turns(turns)), static_cast<float>(sine_turns(turns))};
}
Angle sum(Angle a, Angle b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.cosine * b.sine + a.sine * b.cosine};
}
Angle times(Angle a, int n) {
  Angle result = {1.0f, 0.0f};
  for (int i = 0; i < n; ++i) result = sum(result, a);
  return result;
}

/// Scales in 8 left-handed and 13 right-handed spirals, as plants grow them: 1 on top of a scale, 0 between scales.
/// `azimuth` is around the axis, `height` along it.
float scales(Angle azimuth, float height) {
  const float left = sum(times(azimuth, 8), turned(1.05f * height)).cosine;
  const float right = sum(times(azimuth, 13), turned(-1.30f * height)).cosine;
  return square_root(square_root(0.25f * (1.0f + left) * (1.0f + right) + 0.002f));
}

float radius_at(Vec3 d) {
  // A pear that leans a little.
  float r = far_side(d, {0.0f, -0.16f, 0.0f}, 0.80f);
  r = smooth_larger(r, far_side(d, {0.10f, 0.42f, 0.05f}, 0.56f), 0.40f);

  const float waist = square_root(d.x * d.x + d.z * d.z);
  const Angle azimuth = waist > 1e-6f ? Angle{d.x / waist, d.z / waist} : Angle{1.0f, 0.0f};
  const Vec3 p = r * d;
  // Scales get smaller towards the ends, and grow a little unevenly.
  const float height = 2.1f * d.y / square_root(1.12f - d.y * d.y) + 0.10f * noise(2.3f * p);
  const float strength = smooth_step(0.08f, 0.45f, waist) * (1.0f + 0.35f * noise(1.9f * p + Vec3{4.0f, 1.0f, 7.0f}));
  const float scale = scales(azimuth, height);
  const float tips = smooth_step(0.72f, 1.0f, scale);
  const float ridges = 1.0f - magnitude(noise(7.0f * p + Vec3{2.0f, 9.0f, 5.0f}));
  const float grain = fractal_noise(26.0f * p, 3);
  return r * (0.93f + strength * (0.13f * scale + 0.03f * tips)) + 0.014f * ridges * (1.0f - 0.5f * tips) +
         0.0035f * grain;
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
