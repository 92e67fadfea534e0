// Table, chairs, sofa and rug.
#include "scenes/common/noise.h"
#include "scenes/room/parts.h"

namespace raywalk::room {
namespace {

void add_table(Pieces& pieces) {
  const Placement place = Placement::at(kTableCentre);
  add_box(pieces, place, {-0.85f, kTableTop - 0.035f, -0.475f}, {0.85f, kTableTop, 0.475f}, kWood, kFlat);
  add_box(pieces, place, {-0.74f, kTableTop - 0.12f, -0.37f}, {0.74f, kTableTop - 0.035f, 0.37f}, kWood, kFlat);
  const std::vector<ProfilePoint> leg = {{0.002f, 0.0f},  {0.028f, 0.002f}, {0.030f, 0.06f},
                                         {0.020f, 0.10f}, {0.034f, 0.22f},  {0.038f, 0.40f},
                                         {0.024f, 0.50f}, {0.040f, 0.54f},  {0.040f, 0.64f}};
  for (const float x : {-0.70f, 0.70f}) {
    for (const float z : {-0.33f, 0.33f}) add_turned(pieces, place.inner({x, 0.0f, z}), leg, kWood, kSmooth);
  }
}

/// Faces local +z.
void add_chair(Pieces& pieces, const Placement& place) {
  const std::vector<ProfilePoint> leg = {
      {0.002f, 0.0f}, {0.014f, 0.002f}, {0.018f, 0.15f}, {0.022f, 0.30f}, {0.018f, 0.44f}};
  const std::vector<ProfilePoint> post = {{0.016f, 0.44f}, {0.020f, 0.55f}, {0.017f, 0.75f},
                                          {0.020f, 0.90f}, {0.012f, 0.97f}, {0.001f, 0.975f}};
  for (const float x : {-0.185f, 0.185f}) {
    for (const float z : {-0.185f, 0.185f}) add_turned(pieces, place.inner({x, 0.0f, z}), leg, kWood, kSmooth);
    add_turned(pieces, place.inner({x, 0.0f, -0.195f}), post, kWood, kSmooth);
  }
  add_cushion(pieces, place, {0.0f, 0.455f, 0.0f}, {0.225f, 0.032f, 0.225f}, kPillow, kSmooth);
  add_cushion(pieces, place, {0.0f, 0.88f, -0.195f}, {0.195f, 0.045f, 0.016f}, kWood, kSmooth);
  for (int i = -2; i <= 2; ++i) {
    const float x = 0.062f * static_cast<float>(i);
    add_box(pieces, place, {x - 0.009f, 0.46f, -0.203f}, {x + 0.009f, 0.86f, -0.189f}, kWood, kFlat);
  }
}

/// Faces local +z, 2 m wide.
void add_sofa(Pieces& pieces, const Placement& place) {
  add_cushion(pieces, place, {0.0f, 0.20f, 0.0f}, {1.0f, 0.13f, 0.42f}, kFabric, kSmooth);
  add_cushion(pieces, place, {0.0f, 0.50f, -0.36f}, {1.0f, 0.36f, 0.12f}, kFabric, kSmooth);
  for (const float side : {-1.0f, 1.0f}) {
    add_cushion(pieces, place, {0.93f * side, 0.38f, 0.0f}, {0.12f, 0.25f, 0.43f}, kFabric, kSmooth);
    add_cushion(pieces, place, {0.41f * side, 0.38f, 0.06f}, {0.41f, 0.11f, 0.37f}, kFabric, kSmooth);
    add_cushion(pieces, place, {0.41f * side, 0.63f, -0.20f}, {0.38f, 0.22f, 0.11f}, kFabric, kSmooth);
    const Placement pillow = place.inner({0.62f * side, 0.60f, 0.02f}, 0.06 * side);
    add_cushion(pieces, pillow, {}, {0.20f, 0.19f, 0.075f}, side < 0.0f ? kPillow : kOrange, kSmooth);
    for (const float z : {-0.36f, 0.36f}) {
      add_box(pieces, place, {0.88f * side - 0.03f, 0.0f, z - 0.03f}, {0.88f * side + 0.03f, 0.10f, z + 0.03f}, kWood,
              kFlat);
    }
  }
}

/// A long-haired rug: a rough sheet that touches the floor at its rim.
void add_rug(Pieces& pieces) {
  const float width = 2.9f, depth = 2.2f;
  const Vec3 corner = kTableCentre + Vec3{-0.5f * width, 0.0f, 0.5f * depth};
  const auto height = [=](float u, float v) {
    const float rim = smaller(smaller(u, 1.0f - u) * width, smaller(v, 1.0f - v) * depth);
    const float fade = smaller(rim * 40.0f, 1.0f);
    const Vec3 p = {u * width * 26.0f, 0.0f, v * depth * 26.0f};
    return 0.002f + fade * (0.012f + 0.005f * fractal_noise(p, 3));
  };
  const auto shape = [=](float u, float v) {
    constexpr float kStep = 0.002f;
    const float du = (height(u + kStep, v) - height(u - kStep, v)) / (2.0f * kStep * width);
    const float dv = (height(u, v + kStep) - height(u, v - kStep)) / (2.0f * kStep * depth);
    return SurfacePoint{corner + Vec3{u * width, height(u, v), -v * depth}, normalized({-du, 1.0f, dv})};
  };
  pieces.patch(shape, width / depth, kRug, 2.5 * width * depth);
}

}  // namespace

void add_seating(Pieces& pieces) {
  add_table(pieces);
  add_rug(pieces);
  const float angles[] = {0.015f, -0.02f, 0.51f, 0.47f};
  for (int i = 0; i < 4; ++i) {
    const float x = i % 2 ? 0.42f : -0.42f, z = i < 2 ? -0.62f : 0.62f;
    add_chair(pieces, Placement::at(kTableCentre + Vec3{x, 0.0f, z}, angles[i]));
  }
  add_sofa(pieces, Placement::at({kLeftX + 0.52f, 0.0f, 0.2f}, 0.25));
}

}  // namespace raywalk::room
