// The room itself: carpet tiles, walls, window with blinds and radiator, door, ceiling grid with lamps.
#include "scenes/office/parts.h"

namespace raywalk::office {
namespace {

struct Opening {
  float x0, y0, x1, y1;
};
constexpr Opening kWindow{-1.35f, 0.95f, 1.15f, 2.2f};

void add_walls(Pieces& pieces) {
  const float h = kHalf, w = kWindow.x1 - kWindow.x0;
  constexpr int kTiles = 8;
  const float tile = 2.0f * h / kTiles;
  for (int i = 0; i < kTiles * kTiles; ++i) {
    const int row = i / kTiles, column = i % kTiles;
    add_plate(pieces, {-h + tile * static_cast<float>(column), 0.0f, -h + tile * static_cast<float>(row + 1)},
              {tile, 0.0f, 0.0f}, {0.0f, 0.0f, -tile}, (row + column) % 2 ? kCarpetLight : kCarpetDark);
  }
  const auto window_wall = [&](float x0, float y0, float width, float height) {
    add_plate(pieces, {x0, y0, -h}, {width, 0.0f, 0.0f}, {0.0f, height, 0.0f}, kWall);
  };
  window_wall(-h, 0.0f, kWindow.x0 + h, kHeight);
  window_wall(kWindow.x1, 0.0f, h - kWindow.x1, kHeight);
  window_wall(kWindow.x0, 0.0f, w, kWindow.y0);
  window_wall(kWindow.x0, kWindow.y1, w, kHeight - kWindow.y1);
  add_plate(pieces, {h, 0.0f, h}, {-2.0f * h, 0.0f, 0.0f}, {0.0f, kHeight, 0.0f}, kWall);
  add_plate(pieces, {-h, 0.0f, h}, {0.0f, 0.0f, -2.0f * h}, {0.0f, kHeight, 0.0f}, kAccentWall);
  add_plate(pieces, {h, 0.0f, -h}, {0.0f, 0.0f, 2.0f * h}, {0.0f, kHeight, 0.0f}, kWall);
  add_plate(pieces, {-h, kHeight, -h}, {2.0f * h, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f * h}, kCeiling);
  const Placement here;
  for (const float side : {-1.0f, 1.0f}) {
    const float near = side * h, far = side * (h - 0.012f);
    add_block(pieces, here, {smaller(near, far), 0.0f, -h}, {larger(near, far), 0.08f, h}, kTrim);
  }
  add_block(pieces, here, {-h, 0.0f, -h}, {h, 0.08f, -h + 0.012f}, kTrim);
  add_block(pieces, here, {-h, 0.0f, h - 0.012f}, {0.85f, 0.08f, h}, kTrim);
}

void add_window(Pieces& pieces) {
  const Placement here = Placement::at({0.0f, 0.0f, -kHalf});
  const auto bar = [&](float x0, float y0, float x1, float y1) {
    add_block(pieces, here, {x0, y0, 0.0f}, {x1, y1, 0.06f}, kTrim);
  };
  const float f = 0.05f;
  bar(kWindow.x0 - f, kWindow.y0 - f, kWindow.x0, kWindow.y1 + f);
  bar(kWindow.x1, kWindow.y0 - f, kWindow.x1 + f, kWindow.y1 + f);
  bar(kWindow.x0, kWindow.y1, kWindow.x1, kWindow.y1 + f);
  bar(kWindow.x0, kWindow.y0 - f, kWindow.x1, kWindow.y0);
  for (const float x : {-0.52f, 0.32f}) bar(x - 0.025f, kWindow.y0, x + 0.025f, kWindow.y1);
  add_pad(pieces, here, {-0.1f, kWindow.y0 - 0.06f, 0.10f}, {1.36f, 0.02f, 0.10f}, 0.018f, kTrim, 2);

  // Blinds, let down by half: curved slats on cords.
  constexpr int kSlats = 20;
  const float pitch = 0.042f, left = kWindow.x0 + 0.01f, right = kWindow.x1 - 0.01f;
  add_block(pieces, here, {left, kWindow.y1 - 0.05f, 0.07f}, {right, kWindow.y1 + 0.01f, 0.13f}, kSteel);
  for (int i = 0; i < kSlats; ++i) {
    const float y = kWindow.y1 - 0.075f - pitch * static_cast<float>(i);
    const auto slat = [=](float u, float v) {
      const float across = 2.0f * v - 1.0f;
      return here.point(
          {left + u * (right - left), y - 0.014f * across - 0.006f * across * across, 0.10f + 0.022f * across});
    };
    add_sheet(
        pieces, [=](float u, float v) { return slat(u, 1.0f - v); }, {1, 3}, kSteel);
  }
  const float low = kWindow.y1 - 0.075f - pitch * kSlats;
  add_pad(pieces, here, {0.5f * (left + right), low, 0.10f}, {0.5f * (right - left), 0.012f, 0.025f}, 0.01f, kSteel);
  for (const float x : {-1.1f, -0.1f, 0.9f}) {
    add_tube(pieces, here, {{x, low, 0.125f}, {x, 1.5f, 0.125f}, {x, kWindow.y1, 0.125f}}, 0.002f, {4, 2}, kTrim);
  }
}

void add_radiator(Pieces& pieces) {
  const Placement place = Placement::at({1.1f, 0.0f, -kHalf});
  for (int i = 0; i < 13; ++i) {
    const float x = -0.48f + 0.08f * static_cast<float>(i);
    add_pad(pieces, place, {x, 0.47f, 0.10f}, {0.034f, 0.31f, 0.05f}, 0.03f, kTrim);
  }
  for (const float y : {0.24f, 0.70f}) {
    add_tube(pieces, place, {{-0.52f, y, 0.10f}, {0.0f, y, 0.10f}, {0.52f, y, 0.10f}}, 0.022f, {8, 2}, kTrim);
  }
  add_tube(pieces, place, {{0.52f, 0.24f, 0.10f}, {0.60f, 0.23f, 0.10f}, {0.62f, 0.12f, 0.10f}, {0.62f, 0.0f, 0.10f}},
           0.012f, {8, 9}, kChrome);
}

void add_door(Pieces& pieces) {
  const Placement place = Placement::at({1.35f, 0.0f, kHalf}, 0.5);
  add_block(pieces, place, {-0.43f, 0.005f, 0.0f}, {0.43f, 2.03f, 0.035f}, kWood);
  for (const float y : {0.52f, 1.48f}) {
    add_pad(pieces, place, {0.0f, y, 0.035f}, {0.30f, y < 1.0f ? 0.34f : 0.42f, 0.018f}, 0.016f, kWood, 2);
  }
  add_block(pieces, place, {-0.50f, 0.0f, 0.0f}, {-0.43f, 2.10f, 0.06f}, kTrim);
  add_block(pieces, place, {0.43f, 0.0f, 0.0f}, {0.50f, 2.10f, 0.06f}, kTrim);
  add_block(pieces, place, {-0.43f, 2.03f, 0.0f}, {0.43f, 2.10f, 0.06f}, kTrim);
  add_pad(pieces, place, {-0.36f, 1.0f, 0.037f}, {0.022f, 0.11f, 0.006f}, 0.005f, kBrass);
  add_tube(pieces, place,
           {{-0.36f, 1.03f, 0.04f}, {-0.36f, 1.03f, 0.085f}, {-0.33f, 1.03f, 0.095f}, {-0.24f, 1.025f, 0.09f}}, 0.010f,
           {10, 12}, kBrass);
  for (const float y : {0.25f, 1.0f, 1.8f}) {
    add_lathe(pieces, place.inner({0.435f, y, 0.045f}), {{0.009f, -0.05f}, {0.009f, 0.05f}}, 8, kBrass);
  }
}

/// A grid of bars under the ceiling with two lamps in it.
void add_ceiling(Pieces& pieces) {
  const Placement here = Placement::at({0.0f, kHeight, 0.0f});
  for (int i = -3; i <= 3; ++i) {
    const float at = 0.6f * static_cast<float>(i);
    add_block(pieces, here, {at - 0.012f, -0.010f, -kHalf}, {at + 0.012f, 0.0f, kHalf}, kTrim);
    add_block(pieces, here, {-kHalf, -0.008f, at - 0.012f}, {kHalf, 0.0f, at + 0.012f}, kTrim);
  }
  for (const float x : {-0.9f, 0.9f}) {
    add_plate(pieces, here.point({x - 0.28f, -0.011f, -0.58f}), {0.56f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.16f}, kDiffuser);
    for (int i = 0; i < 9; ++i) {
      const float z = -0.52f + 0.13f * static_cast<float>(i);
      add_plate(pieces, here.point({x - 0.28f, -0.05f, z}), {0.56f, 0.0f, 0.0f}, {0.0f, 0.038f, 0.0f}, kChrome);
    }
    for (const float side : {-1.0f, 1.0f}) {
      const float a = x + 0.28f * side;
      add_block(pieces, here, {a - 0.015f, -0.055f, -0.60f}, {a + 0.015f, 0.0f, 0.60f}, kSteel);
      const float b = 0.58f * side;
      add_block(pieces, here, {x - 0.28f, -0.055f, b - 0.015f}, {x + 0.28f, 0.0f, b + 0.015f}, kSteel);
    }
  }
}

}  // namespace

void add_shell(Pieces& pieces) {
  add_walls(pieces);
  add_window(pieces);
  add_radiator(pieces);
  add_door(pieces);
  add_ceiling(pieces);
}

}  // namespace raywalk::office
