// The head: a calm face, long ears, hair in curls, and a flame on the crown.
#include "scenes/buddha/parts.h"
#include "scenes/common/noise.h"

namespace raywalk::buddha {
namespace {

constexpr Vec3 kCentre{0.0f, 1.725f, -0.008f};  // of the skull
constexpr float kSkull = 0.101f;
constexpr Vec3 kCrown{0.0f, 1.842f, -0.022f};
constexpr float kCrownRadius = 0.048f;
constexpr float kCurl = 0.0118f;

float face(Vec3 p) {
  const Vec3 q = {magnitude(p.x), p.y, p.z};
  float d = to_rod(p, {0.0f, 1.728f, -0.006f}, {0.0f, 1.712f, 0.000f}, 0.099f, 0.097f);
  d = merged(d, to_rod(q, {0.0f, 1.655f, 0.040f}, {0.028f, 1.665f, 0.030f}, 0.050f, 0.052f), 0.05f);
  d = merged(d, to_ellipsoid(p, {0.0f, 1.628f, 0.070f}, {0.026f, 0.019f, 0.020f}), 0.02f);
  d = merged(d, to_ellipsoid(q, {0.047f, 1.692f, 0.066f}, {0.028f, 0.028f, 0.022f}), 0.03f);
  // Hollows of the eyes, arched brows above them, lids that are almost closed.
  const float hollow = to_ellipsoid(q, {0.038f, 1.731f, 0.108f}, {0.027f, 0.013f, 0.016f});
  d = -merged(-d, hollow, 0.014f);
  d = merged(d, to_rod(q, {0.011f, 1.7520f, 0.0945f}, {0.040f, 1.7590f, 0.0850f}, 0.0032f, 0.0034f), 0.008f);
  d = merged(d, to_rod(q, {0.040f, 1.7590f, 0.0850f}, {0.070f, 1.7480f, 0.0640f}, 0.0034f, 0.0022f), 0.008f);
  const float lid = to_ellipsoid(q, {0.038f, 1.727f, 0.0800f}, {0.0215f, 0.0120f, 0.0150f});
  const float line = (p.y - 1.7225f - 3.0f * (q.x - 0.038f) * (q.x - 0.038f)) * 520.0f;
  d = merged(d, lid + 0.0035f / (1.0f + line * line), 0.004f);
  // Nose, its wings, and the lips.
  d = merged(d, to_rod(p, {0.0f, 1.745f, 0.0930f}, {0.0f, 1.6990f, 0.1130f}, 0.0060f, 0.0105f), 0.012f);
  d = merged(d, to_ellipsoid(q, {0.0105f, 1.6965f, 0.1040f}, {0.0085f, 0.0075f, 0.0095f}), 0.006f);
  d = merged(d, to_rod(q, {0.0f, 1.6720f, 0.1010f}, {0.0310f, 1.6745f, 0.0850f}, 0.0058f, 0.0030f), 0.005f);
  d = merged(d, to_rod(q, {0.0f, 1.6600f, 0.0985f}, {0.0240f, 1.6655f, 0.0870f}, 0.0070f, 0.0034f), 0.004f);
  // The mark between the brows.
  d = merged(d, to_ellipsoid(p, {0.0f, 1.7700f, 0.0850f}, {0.0050f, 0.0050f, 0.0040f}), 0.002f);
  return d - 0.0004f * fractal_noise(70.0f * p, 2);
}

/// Long lobes; `side` is 1 on the figure's left.
void add_ear(Pieces& pieces, float side) {
  const auto ear = [=](Vec3 p) {
    const Vec3 q = {side * p.x, p.y, p.z};
    float d = to_ellipsoid(q, {0.103f, 1.722f, -0.006f}, {0.014f, 0.040f, 0.026f});
    d = merged(d, to_ellipsoid(q, {0.101f, 1.655f, 0.002f}, {0.012f, 0.048f, 0.014f}), 0.02f);
    const float shell = to_ellipsoid(q, {0.117f, 1.724f, 0.000f}, {0.011f, 0.027f, 0.014f});
    d = -merged(-d, shell, 0.004f);
    return -merged(-d, to_ellipsoid(q, {0.114f, 1.640f, 0.003f}, {0.014f, 0.022f, 0.0045f}), 0.004f);
  };
  add_carved(pieces, {0.102f * side, 1.69f, -0.002f}, {0.016f, 0.085f, 0.026f}, ear, kSkin, 2.0 * kEven);
}

/// True where hair grows: behind a line that runs over the forehead and down behind the ears.
bool is_hair(Vec3 d) {
  return d.y > 0.50f + 0.18f * d.z || (d.z < 0.12f - 0.25f * d.y && d.y > -0.62f && !(d.z > -0.35f && d.y < -0.05f));
}

/// Curls in the order of sunflower seeds, which spreads them evenly.
void add_curls(Pieces& pieces, Vec3 centre, Vec3 half, int seeds, bool everywhere) {
  for (int i = 0; i < seeds; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(seeds);
    const float ring = square_root(1.0f - y * y);
    const double turn = 0.381966011 * i;
    const Vec3 d = {ring * static_cast<float>(cosine_turns(turn)), y, ring * static_cast<float>(sine_turns(turn))};
    if (everywhere ? d.y < -0.45f : !is_hair(d)) continue;
    add_sphere(pieces, centre + half * d, kCurl, kHair, kEven);
  }
}

/// A drop whose ridges wind upwards.
void add_flame(Pieces& pieces) {
  const float bottom = kCrown.y + kCrownRadius - 0.004f, tall = kTop - bottom;
  const auto point = [=](double u, double v) {
    const float t = static_cast<float>(v);
    const float swell = square_root(larger(t, 0.0f)) * (1.0f - t) * (1.0f - 0.35f * t);
    const float ridge = 1.0f + 0.10f * static_cast<float>(cosine_turns(6.0 * (u + 0.45 * v)));
    const float r = 0.0015f + 0.058f * swell * ridge;
    return Vec3{kCrown.x + r * static_cast<float>(cosine_turns(u)), bottom + tall * t,
                kCrown.z - r * static_cast<float>(sine_turns(u))};
  };
  const auto shape = [=](float u, float v) {
    constexpr double kStep = 5e-4;
    const double low = v > kStep ? v - kStep : 0.0, high = v < 1.0 - kStep ? v + kStep : 1.0;
    const Vec3 du = point(u + kStep, v) - point(u - kStep, v), dv = point(u, high) - point(u, low);
    return SurfacePoint{point(u, v), normalized(cross(du, dv))};
  };
  pieces.patch(shape, 1.2f, kHair, kRelief * 0.02);
}

}  // namespace

void add_head(Pieces& pieces) {
  add_carved(pieces, {0.0f, 1.705f, 0.008f}, {0.100f, 0.125f, 0.105f}, face, kSkin, 3.0 * kEven);
  add_ear(pieces, 1.0f);
  add_ear(pieces, -1.0f);
  // A cap under the curls.
  const auto cap = [](Vec3 p) {
    const float d =
        to_ellipsoid(p, kCentre + Vec3{0.0f, 0.012f, -0.010f}, {kSkull + 0.003f, kSkull + 0.005f, kSkull + 0.002f});
    return merged(d, to_rod(p, kCrown, kCrown + Vec3{0.0f, 0.004f, 0.0f}, kCrownRadius, kCrownRadius), 0.02f);
  };
  add_carved(pieces, kCentre + Vec3{0.0f, 0.02f, -0.01f}, {0.105f, 0.13f, 0.105f}, cap, kHair, kEven);
  add_curls(pieces, kCentre + Vec3{0.0f, 0.012f, -0.010f}, {kSkull + 0.003f, kSkull + 0.005f, kSkull + 0.003f}, 560,
            false);
  add_curls(pieces, kCrown, {kCrownRadius, kCrownRadius, kCrownRadius}, 130, true);
  add_flame(pieces);
}

}  // namespace raywalk::buddha
