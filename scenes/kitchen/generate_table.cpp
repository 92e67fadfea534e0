// The high table, its bar stools, and what is laid on it.
#include "scenes/kitchen/parts.h"

namespace raywalk::kitchen {
namespace {

/// A low stack of cushions on a chromed foot, with a ring for the feet.
void add_stool(Pieces& pieces, const Placement& place) {
  add_turned(pieces, place,
             {{0.002f, 0.0f},
              {0.20f, 0.002f},
              {0.205f, 0.012f},
              {0.17f, 0.03f},
              {0.07f, 0.07f},
              {0.032f, 0.13f},
              {0.026f, 0.22f},
              {0.026f, 0.42f},
              {0.026f, 0.62f}},
             kChrome, kFine);
  const Vec3 up = {0.0f, 1.0f, 0.0f};
  add_ring(pieces, place.point({0.0f, 0.27f, 0.0f}), up, 0.155f, 0.011f, kChrome, 3.0 * kTiny);
  for (int i = 0; i < 3; ++i) {
    const Placement spoke = place.inner({}, i / 3.0);
    add_rod(pieces, spoke.point({0.02f, 0.27f, 0.0f}), spoke.point({0.155f, 0.27f, 0.0f}), 0.008f, kChrome,
            2.0 * kTiny);
  }
  for (int i = 0; i < 3; ++i) {
    add_ring(pieces, place.point({0.0f, 0.632f + 0.026f * static_cast<float>(i), 0.0f}), up, 0.168f, 0.015f,
             i % 2 ? kChrome : kLeather, kTiny);
  }
  add_turned(pieces, place, {{0.026f, 0.61f}, {0.17f, 0.615f}, {0.17f, 0.64f}, {0.17f, 0.69f}}, kLeather, kFine);
  add_turned(pieces, place,
             {{0.180f, 0.695f}, {0.190f, 0.715f}, {0.180f, 0.738f}, {0.12f, 0.752f}, {0.05f, 0.756f}, {0.002f, 0.757f}},
             kLeather, kFine);
}

void add_plate(Pieces& pieces, const Placement& place) {
  add_turned(pieces, place,
             {{0.002f, 0.001f},
              {0.075f, 0.001f},
              {0.082f, 0.006f},
              {0.128f, 0.020f},
              {0.130f, 0.023f},
              {0.125f, 0.024f},
              {0.086f, 0.012f},
              {0.078f, 0.008f},
              {0.002f, 0.007f}},
             kPlate, kTiny);
}

// Glasses are one thin wall each, which light passes straight.

void add_wine_glass(Pieces& pieces, const Placement& place) {
  add_turned(pieces, place,
             {{0.001f, 0.001f},
              {0.036f, 0.001f},
              {0.034f, 0.004f},
              {0.008f, 0.010f},
              {0.0045f, 0.03f},
              {0.0045f, 0.08f},
              {0.010f, 0.095f},
              {0.036f, 0.125f},
              {0.040f, 0.155f},
              {0.032f, 0.20f}},
             kGlass, 4.0 * kTiny);
}

void add_tumbler(Pieces& pieces, const Placement& place) {
  add_turned(pieces, place, {{0.001f, 0.001f}, {0.028f, 0.001f}, {0.031f, 0.006f}, {0.034f, 0.06f}, {0.037f, 0.11f}},
             kGlass, 4.0 * kTiny);
}

/// Fork to the left, knife to the right.
void add_cutlery(Pieces& pieces, const Placement& place) {
  const auto bar = [&](float x0, float x1, float z0, float z1) {
    add_box(pieces, place, {x0, 0.0f, z0}, {x1, 0.003f, z1}, kChrome, kFlat);
  };
  bar(-0.169f, -0.161f, -0.02f, 0.09f);
  bar(-0.175f, -0.155f, -0.045f, -0.02f);
  for (int i = 0; i < 4; ++i) {
    const float x = -0.175f + 0.0057f * static_cast<float>(i);
    bar(x, x + 0.0029f, -0.09f, -0.045f);
  }
  bar(0.161f, 0.169f, 0.0f, 0.09f);
  bar(0.156f, 0.172f, -0.10f, 0.0f);
}

void add_fruit_bowl(Pieces& pieces, const Placement& place) {
  add_turned(pieces, place,
             {{0.002f, 0.001f},
              {0.07f, 0.001f},
              {0.075f, 0.012f},
              {0.125f, 0.04f},
              {0.165f, 0.095f},
              {0.168f, 0.11f},
              {0.160f, 0.11f},
              {0.12f, 0.05f},
              {0.065f, 0.022f},
              {0.002f, 0.018f}},
             kChrome, 2.0 * kTiny);
  const u32 kinds[] = {kOrange, kApple, kLemon};
  for (int i = 0; i < 5; ++i) {
    const Vec3 at = place.inner({}, i / 5.0).point({0.082f, 0.085f, 0.0f});
    add_sphere(pieces, at, 0.042f, kinds[i % 3], kTiny);
  }
  add_sphere(pieces, place.point({0.0f, 0.135f, 0.0f}), 0.044f, kOrange, kTiny);
}

void add_bottle(Pieces& pieces, const Placement& place) {
  add_turned(pieces, place,
             {{0.001f, 0.012f},
              {0.030f, 0.002f},
              {0.038f, 0.008f},
              {0.038f, 0.10f},
              {0.038f, 0.19f},
              {0.030f, 0.225f},
              {0.0145f, 0.25f},
              {0.0135f, 0.29f},
              {0.016f, 0.295f},
              {0.016f, 0.31f},
              {0.001f, 0.313f}},
             kBottle, 2.0 * kTiny);
}

}  // namespace

void add_table(Pieces& pieces) {
  const Placement place = Placement::at(kTable, 0.02);
  add_cushion(pieces, place, {0.0f, kTableTop - 0.025f, 0.0f}, {1.02f, 0.025f, 0.50f}, kTableWood, kFine);
  for (const float x : {-0.55f, 0.55f}) {
    add_turned(pieces, place.inner({x, 0.0f, 0.0f}),
               {{0.002f, 0.0f},
                {0.24f, 0.002f},
                {0.245f, 0.015f},
                {0.20f, 0.03f},
                {0.075f, 0.05f},
                {0.055f, 0.09f},
                {0.055f, 0.45f},
                {0.055f, 0.80f},
                {0.10f, 0.86f},
                {0.20f, 0.872f}},
               kChrome, kFine);
  }
  for (int i = 0; i < 4; ++i) {
    const float side = i < 2 ? -1.0f : 1.0f, x = i % 2 ? 0.46f : -0.46f;
    const Placement seat = place.inner({x, kTableTop, 0.28f * side}, side < 0.0f ? 0.5 : 0.0);
    add_plate(pieces, seat);
    add_cutlery(pieces, seat);
    add_wine_glass(pieces, seat.inner({0.17f, 0.0f, -0.15f}));
    add_tumbler(pieces, seat.inner({0.08f, 0.0f, -0.18f}));
    add_stool(pieces, place.inner({x + 0.05f * side, 0.0f, 0.74f * side}));
  }
  add_stool(pieces, place.inner({-1.35f, 0.0f, 0.12f}));
  add_fruit_bowl(pieces, place.inner({0.0f, kTableTop, 0.0f}));
  add_bottle(pieces, place.inner({0.24f, kTableTop, 0.03f}));
  add_plate(pieces, place.inner({0.84f, kTableTop, 0.0f}));
}

}  // namespace raywalk::kitchen
