// The base in three drums, the middle one with clouds in relief, and a lotus of three rows of petals.
#include "scenes/buddha/parts.h"
#include "scenes/common/noise.h"

namespace raywalk::buddha {
namespace {

void add_drums(Pieces& pieces) {
  add_turned(pieces, {},
             {{kRadius, 0.0f},
              {kRadius, 0.012f},
              {kRadius, 0.085f},
              {kRadius - 0.01f, 0.098f},
              {0.372f, 0.102f},
              {0.368f, 0.112f},
              {0.382f, 0.135f},
              {0.380f, 0.160f},
              {0.350f, 0.178f},
              {0.322f, 0.186f},
              {0.318f, 0.200f},
              {0.326f, 0.216f},
              {0.314f, 0.234f},
              {0.286f, 0.244f}},
             kBase, kEven);
  add_turned(pieces, {},
             {{0.286f, 0.556f},
              {0.312f, 0.566f},
              {0.322f, 0.582f},
              {0.312f, 0.598f},
              {0.318f, 0.612f},
              {0.350f, 0.622f},
              {0.372f, 0.642f},
              {0.374f, 0.668f},
              {0.352f, 0.686f},
              {0.330f, 0.692f},
              {0.330f, 0.704f},
              {0.30f, 0.712f},
              {0.002f, 0.716f}},
             kBase, kEven);
  add_disc(pieces, {}, {0.0f, -1.0f, 0.0f}, kRadius, kBase, kEven);
  // Clouds: ridges of a noise that is itself stirred by a noise.
  const auto point = [](float u, float v) {
    const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
    const Vec3 p = {7.0f * c, 9.0f * v, -7.0f * s};
    const Vec3 stir = {noise(0.8f * p + Vec3{3.0f, 0.0f, 0.0f}), noise(0.8f * p + Vec3{0.0f, 5.0f, 0.0f}),
                       noise(0.8f * p + Vec3{0.0f, 0.0f, 9.0f})};
    const float ridge = 1.0f - magnitude(noise(p * 0.45f + 1.3f * stir)) * 2.2f;
    const float rim = ramp(0.0f, 0.08f, v) * ramp(0.0f, 0.08f, 1.0f - v);
    const float radius =
        0.276f + 0.016f * rim * ramp(0.15f, 0.75f, ridge) + 0.010f * (2.0f * v - 1.0f) * (2.0f * v - 1.0f);
    return Vec3{radius * c, 0.243f + 0.314f * v, -radius * s};
  };
  const auto relief = [=](float u, float v) {
    constexpr float kStep = 4e-4f;
    const Vec3 du = point(u + kStep, v) - point(u - kStep, v), dv = point(u, v + kStep) - point(u, v - kStep);
    return SurfacePoint{point(u, v), normalized(cross(du, dv))};
  };
  pieces.patch(relief, 5.6f, kBase, kRelief * 0.55);
  constexpr int kBeads = 48;
  for (int i = 0; i < kBeads; ++i) {
    for (const float y : {0.258f, 0.543f}) {
      add_sphere(pieces, Placement::at({}, static_cast<double>(i) / kBeads).point({0.289f, y, 0.0f}), 0.0135f, kBase,
                 kEven);
    }
  }
}

/// One petal around `root`: up is +y and out is +z of the place; it leans out by `lean` and curls at its tip.
void add_petal(Pieces& pieces, const Placement& place, float half_width, float tall, float lean, u32 material) {
  const auto point = [=](Vec3 d) {
    const float t = 0.5f * (d.y + 1.0f);
    const float narrow = 1.0f - 0.55f * ramp(0.55f, 1.0f, t), aside = d.x * narrow;
    const float cup = -0.45f * half_width * aside * aside;
    const float veins =
        0.0016f * static_cast<float>(cosine_turns(3.0 * aside)) * ramp(0.1f, 0.4f, t) * ramp(0.0f, 0.3f, d.z);
    const float out = 0.030f * d.z * (1.0f - 0.35f * t) + cup + lean * t + 0.35f * lean * ramp(0.6f, 1.0f, t) + veins;
    return place.point({half_width * aside, tall * t - 0.12f * tall * aside * aside, out});
  };
  const auto shape = [=](Vec3 d, float spacing) {
    const Across plane = across(d);
    const float step = 0.4f * spacing;
    const Vec3 along_u = point(normalized(d + step * plane.first)) - point(normalized(d - step * plane.first));
    const Vec3 along_v = point(normalized(d + step * plane.second)) - point(normalized(d - step * plane.second));
    return SurfacePoint{point(d), normalized(cross(along_u, along_v))};
  };
  pieces.ball(shape, material, kEven * 4.0 * half_width * tall);
}

void add_lotus(Pieces& pieces) {
  constexpr int kPetals = 18;
  for (int i = 0; i < kPetals; ++i) {
    const double turn = static_cast<double>(i) / kPetals, between = (i + 0.5) / kPetals;
    add_petal(pieces, Placement::at({}, turn).inner({0.0f, 0.722f, 0.262f}), 0.058f, 0.175f, 0.072f, kLotus);
    add_petal(pieces, Placement::at({}, between).inner({0.0f, 0.745f, 0.252f}), 0.056f, 0.195f, 0.062f, kLotus);
    add_petal(pieces, Placement::at({}, turn).inner({0.0f, 0.775f, 0.240f}), 0.054f, 0.200f, 0.055f, kLotus);
  }
  add_turned(pieces, {},
             {{0.29f, 0.70f},
              {0.27f, 0.76f},
              {0.285f, 0.88f},
              {0.292f, 0.945f},
              {0.275f, kSeat},
              {0.10f, kSeat + 0.004f},
              {0.002f, kSeat + 0.004f}},
             kLotus, kEven);
}

}  // namespace

void add_base(Pieces& pieces) {
  add_drums(pieces);
  add_lotus(pieces);
}

}  // namespace raywalk::buddha
