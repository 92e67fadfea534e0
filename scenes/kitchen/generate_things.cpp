// What stands and hangs around: a toy car, lamps, jars, plants, a toaster, a clock.
#include <utility>
#include "scenes/kitchen/parts.h"

namespace raywalk::kitchen {
namespace {

/// Drives towards local +x; about 35 cm long.
void add_toy_car(Pieces& pieces, const Placement& place) {
  add_cushion(pieces, place, {0.0f, 0.075f, 0.0f}, {0.175f, 0.036f, 0.078f}, kToyRed, 2.0 * kTiny);
  add_cushion(pieces, place, {-0.025f, 0.118f, 0.0f}, {0.085f, 0.042f, 0.062f}, kBlackGlass, 2.0 * kTiny);
  add_cushion(pieces, place, {-0.028f, 0.150f, 0.0f}, {0.066f, 0.012f, 0.056f}, kToyRed, kTiny);
  add_cushion(pieces, place, {0.168f, 0.055f, 0.0f}, {0.018f, 0.012f, 0.072f}, kChrome, kTiny);
  add_cushion(pieces, place, {-0.168f, 0.055f, 0.0f}, {0.018f, 0.012f, 0.072f}, kChrome, kTiny);
  const Vec3 axle = place.direction({0.0f, 0.0f, 1.0f});
  for (const float x : {-0.105f, 0.105f}) {
    for (const float z : {-0.072f, 0.072f}) {
      const Vec3 hub = place.point({x, 0.040f, z});
      add_ring(pieces, hub, axle, 0.027f, 0.013f, kRubber, 3.0 * kTiny);
      add_rod(pieces, hub - 0.010f * axle, hub + 0.010f * axle, 0.022f, kToyYellow, 3.0 * kTiny);
    }
    add_sphere(pieces, place.point({0.166f, 0.085f, 0.45f * x}), 0.013f, kBulb, kTiny);
  }
  // The key to wind it up.
  add_rod(pieces, place.point({-0.09f, 0.14f, 0.0f}), place.point({-0.14f, 0.20f, 0.0f}), 0.005f, kChrome, kTiny);
  for (const float z : {-0.022f, 0.022f}) {
    add_ring(pieces, place.point({-0.147f, 0.208f, z}), place.direction(normalized({0.77f, 0.64f, 0.0f})), 0.020f,
             0.005f, kChrome, 4.0 * kTiny);
  }
}

void add_pendant(Pieces& pieces, Vec3 at) {
  const Placement place = Placement::at(at);
  add_turned(pieces, place,
             {{0.19f, 0.0f}, {0.185f, 0.03f}, {0.15f, 0.09f}, {0.08f, 0.15f}, {0.035f, 0.18f}, {0.030f, 0.22f}}, kShade,
             kFine);
  add_ring(pieces, at, {0.0f, 1.0f, 0.0f}, 0.19f, 0.006f, kChrome, kTiny);
  add_sphere(pieces, at + Vec3{0.0f, 0.09f, 0.0f}, 0.035f, kBulb, kTiny);
  add_rod(pieces, at + Vec3{0.0f, 0.21f, 0.0f}, {at.x, kHeight - 0.02f, at.z}, 0.006f, kRubber, kFine);
}

/// A glass jar with its lid and something inside.
void add_jar(Pieces& pieces, const Placement& place, float height, u32 inside) {
  const float r = 0.055f, h = height;
  add_turned(pieces, place, {{0.001f, 0.001f}, {r, 0.001f}, {r, 0.5f * h}, {r, 0.9f * h}, {0.8f * r, h}}, kGlass,
             kTiny);
  add_turned(pieces, place,
             {{0.001f, 0.006f}, {0.88f * r, 0.006f}, {0.88f * r, 0.3f * h}, {0.88f * r, 0.6f * h}, {0.001f, 0.62f * h}},
             inside, kTiny);
  add_turned(pieces, place, {{0.85f * r, h}, {0.85f * r, h + 0.02f}, {0.001f, h + 0.022f}}, kWood, kTiny);
}

void add_plant(Pieces& pieces, Vec3 at) {
  add_turned(pieces, Placement::at(at),
             {{0.002f, 0.001f},
              {0.065f, 0.001f},
              {0.085f, 0.13f},
              {0.095f, 0.14f},
              {0.095f, 0.16f},
              {0.080f, 0.16f},
              {0.075f, 0.14f},
              {0.002f, 0.135f}},
             kPot, kTiny);
  Random random(23);
  for (int i = 0; i < 26; ++i) {
    const Placement leaf = Placement::at(at + Vec3{0.0f, 0.13f, 0.0f}, 0.381966 * i);
    const float young = static_cast<float>(i) / 26.0f, reach = random.between(0.13f, 0.2f) * (1.0f - 0.5f * young);
    const float rise = 0.10f + 0.20f * young + random.between(0.0f, 0.05f);
    const auto shape = [=](float u, float v) {
      const float half = 0.9f * reach * v * (1.0f - v) + 0.001f, across = 2.0f * u - 1.0f;
      const float slope = rise * (1.7f - 1.9f * v) / reach;
      const Vec3 p = {reach * v, rise * v * (1.7f - 0.95f * v) + 0.2f * half * across * across, half * across};
      return SurfacePoint{leaf.point(p), leaf.direction(normalized({-slope, 1.0f, -0.4f * across}))};
    };
    pieces.patch(shape, 0.4f, kLeaf, 3.0 * kFine * reach * reach);
  }
}

void add_toaster(Pieces& pieces, const Placement& place) {
  add_cushion(pieces, place, {0.0f, 0.105f, 0.0f}, {0.15f, 0.095f, 0.085f}, kChrome, 2.0 * kTiny);
  for (const float z : {-0.03f, 0.03f}) {
    add_box(pieces, place, {-0.10f, 0.19f, z - 0.011f}, {0.10f, 0.203f, z + 0.011f}, kIron, kFlat);
    add_box(pieces, place, {-0.085f, 0.19f, z - 0.007f}, {0.085f, 0.225f, z + 0.007f}, kWood, kFlat);
  }
  add_box(pieces, place, {0.14f, 0.11f, -0.015f}, {0.175f, 0.13f, 0.015f}, kIron, kFlat);
}

void add_clock(Pieces& pieces, Vec3 centre, Vec3 out) {
  add_disc(pieces, centre + 0.02f * out, out, 0.17f, kPlate, kFine);
  add_ring(pieces, centre + 0.02f * out, out, 0.17f, 0.018f, kCopper, kTiny);
  const Vec3 up = {0.0f, 1.0f, 0.0f}, right = cross(up, out), face = centre + 0.026f * out;
  for (int i = 0; i < 12; ++i) {
    const float c = static_cast<float>(cosine_turns(i / 12.0)), s = static_cast<float>(sine_turns(i / 12.0));
    const Vec3 radial = c * up + s * right, beside = c * right - s * up;
    add_slab(pieces, face + 0.135f * radial, 0.004f * beside, 0.012f * radial, 0.002f * out, kIron, kFlat);
  }
  const Vec3 hour = normalized(0.6f * up + 0.8f * right), minute = normalized(0.87f * up - 0.5f * right);
  for (const auto& [hand, reach] : {std::pair{hour, 0.075f}, std::pair{minute, 0.12f}}) {
    const Vec3 beside = cross(hand, out);
    add_slab(pieces, face + 0.5f * reach * hand + 0.004f * out, 0.004f * beside, 0.5f * reach * hand, 0.002f * out,
             kIron, kFlat);
  }
}

void add_on_worktop(Pieces& pieces) {
  const Placement far_wall = on_far_wall(0.0f);
  const u32 contents[] = {kLemon, kWood, kOrange, kPlate};
  for (int i = 0; i < 4; ++i) {
    const float x = 1.55f + 0.16f * static_cast<float>(i);
    add_jar(pieces, far_wall.inner({x, kTop, 0.17f}), 0.24f - 0.025f * static_cast<float>(i), contents[i]);
  }
  add_toaster(pieces, far_wall.inner({2.75f, kTop, 0.28f}, 0.03));
  for (int i = 0; i < 6; ++i) {
    const float s = static_cast<float>(i);
    add_turned(pieces, far_wall.inner({-0.95f + 0.02f * s, kTop, 0.35f}, 0.0),
               {{0.10f, 0.006f * s},
                {0.13f, 0.012f + 0.006f * s},
                {0.125f, 0.014f + 0.006f * s},
                {0.002f, 0.008f + 0.006f * s}},
               kPlate, kFine);
  }
  // A knife block and a chopping board on the left.
  const Placement left = on_left_wall(0.0f);
  add_box(pieces, left, {2.0f, kTop, 0.12f}, {2.35f, kTop + 0.025f, 0.40f}, kWood, kFlat);
  add_sphere(pieces, left.point({2.10f, kTop + 0.068f, 0.24f}), 0.043f, kApple, kTiny);
  add_sphere(pieces, left.point({2.22f, kTop + 0.065f, 0.31f}), 0.040f, kLemon, kTiny);
  add_box(pieces, left, {2.60f, kTop, 0.12f}, {2.70f, kTop + 0.24f, 0.26f}, kWood, kFlat);
  for (int i = 0; i < 4; ++i) {
    const float z = 0.14f + 0.03f * static_cast<float>(i);
    add_box(pieces, left, {2.63f, kTop + 0.24f, z}, {2.67f, kTop + 0.33f - 0.01f * static_cast<float>(i), z + 0.017f},
            kRubber, kFlat);
  }
}

}  // namespace

void add_things(Pieces& pieces) {
  add_toy_car(pieces, Placement::at({-0.75f, 0.0f, 1.75f}, 0.06));
  for (const float x : {-0.55f, 0.55f}) add_pendant(pieces, kTable + Vec3{x, 2.05f, 0.0f});
  add_pendant(pieces, {-2.2f, 2.75f, -1.4f});
  add_on_worktop(pieces);
  add_plant(pieces, {-0.72f, 1.16f, -kEndZ + 0.10f});
  add_plant(pieces, {kSideX - 0.10f, 0.95f, -1.3f});
  add_clock(pieces, {0.0f, 3.05f, -kEndZ}, {0.0f, 0.0f, 1.0f});
}

}  // namespace raywalk::kitchen
