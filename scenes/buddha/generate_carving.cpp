// Distances, and the way inwards along a ray.
#include "scenes/buddha/carving.h"

namespace raywalk::buddha {
namespace {

constexpr float kOutside = 1.9f;    // where a ray starts, in units of `half`
constexpr float kCautious = 0.45f;  // part of the distance that a step takes: bumps make distances too long
constexpr int kSteps = 160;
constexpr float kClose = 2e-5f, kGradient = 6e-4f;

}  // namespace

float to_rod(Vec3 p, Vec3 a, Vec3 b, float radius_a, float radius_b) {
  const Vec3 along = b - a;
  const float t = smaller(larger(dot(p - a, along) / dot(along, along), 0.0f), 1.0f);
  return length(p - a - t * along) - (radius_a + t * (radius_b - radius_a));
}

float to_ellipsoid(Vec3 p, Vec3 centre, Vec3 half) {
  const Vec3 q = {(p.x - centre.x) / half.x, (p.y - centre.y) / half.y, (p.z - centre.z) / half.z};
  const float least = smaller(half.x, smaller(half.y, half.z));
  return (length(q) - 1.0f) * least;
}

float merged(float a, float b, float width) {
  const float h = larger(0.0f, width - magnitude(a - b)) / width;
  return smaller(a, b) - 0.25f * width * h * h;
}

float ramp(float lo, float hi, float x) {
  const float t = smaller(larger((x - lo) / (hi - lo), 0.0f), 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

void add_carved(Pieces& pieces, Vec3 centre, Vec3 half, Field field, u32 material, double density) {
  const auto shape = [=](Vec3 d, float) {
    const Vec3 reach = kOutside * (half * d);
    const Vec3 inwards = -normalized(reach);
    const float most = length(reach);
    float gone = 0.0f;
    for (int i = 0; i < kSteps && gone < most; ++i) {
      const float distance = field(centre + reach + gone * inwards);
      if (distance < kClose) break;
      gone += kCautious * distance;
    }
    const Vec3 p = centre + reach + smaller(gone, 0.995f * most) * inwards;
    const Vec3 dx = {kGradient, 0.0f, 0.0f}, dy = {0.0f, kGradient, 0.0f}, dz = {0.0f, 0.0f, kGradient};
    const Vec3 slope = {field(p + dx) - field(p - dx), field(p + dy) - field(p - dy), field(p + dz) - field(p - dz)};
    return SurfacePoint{p, normalized(slope)};
  };
  pieces.ball(shape, material, density * 4.0 * (half.x * half.y + half.y * half.z + half.z * half.x));
}

}  // namespace raywalk::buddha
