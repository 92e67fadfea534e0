// The room: a tiled floor, walls with two windows, wall tiles above the worktop, beams under the ceiling.
#include "scenes/kitchen/parts.h"

namespace raywalk::kitchen {
namespace {

void add_floor(Pieces& pieces) {
  constexpr int kTiles = 16;
  const float width = 2.0f * kSideX / kTiles, depth = 2.0f * kEndZ / kTiles;
  for (int i = 0; i < kTiles * kTiles; ++i) {
    const int column = i % kTiles, row = i / kTiles;
    add_quad(pieces, {-kSideX + width * static_cast<float>(column), 0.0f, -kEndZ + depth * static_cast<float>(row + 1)},
             {width, 0.0f, 0.0f}, {0.0f, 0.0f, -depth}, (column + row) % 2 ? kDarkTile : kLightTile, kFlat);
  }
}

/// A wall from a to b along x in the place's coordinates, seen from +z, with a framed and barred opening.
void add_window_wall(Pieces& pieces, const Placement& place, float a, float b, const Opening& o) {
  const auto field = [&](float x0, float y0, float x1, float y1) {
    add_quad(pieces, place.point({x0, y0, 0.0f}), place.direction({x1 - x0, 0.0f, 0.0f}), {0.0f, y1 - y0, 0.0f}, kWall,
             kFlat);
  };
  field(a, 0.0f, o.a, kHeight);
  field(o.b, 0.0f, b, kHeight);
  field(o.a, 0.0f, o.b, o.y0);
  field(o.a, o.y1, o.b, kHeight);
  const float f = 0.07f;
  const auto bar = [&](float x0, float y0, float x1, float y1, float out) {
    add_box(pieces, place, {x0, y0, 0.0f}, {x1, y1, out}, kTrim, kFlat);
  };
  bar(o.a - f, o.y0, o.a, o.y1 + f, 0.05f);
  bar(o.b, o.y0, o.b + f, o.y1 + f, 0.05f);
  bar(o.a, o.y1, o.b, o.y1 + f, 0.05f);
  bar(o.a - f - 0.05f, o.y0 - 0.05f, o.b + f + 0.05f, o.y0, 0.14f);
  const int wings = o.b - o.a > 3.0f ? 3 : 2;
  for (int i = 1; i < wings; ++i) {
    const float x = o.a + (o.b - o.a) * static_cast<float>(i) / static_cast<float>(wings);
    bar(x - 0.035f, o.y0, x + 0.035f, o.y1, 0.03f);
    add_handle(pieces, place, {x, o.y0 + 0.62f, 0.03f}, {x, o.y0 + 0.76f, 0.03f}, 0.04f);
  }
  const float y = o.y0 + 0.70f * (o.y1 - o.y0);
  bar(o.a, y - 0.02f, o.b, y + 0.02f, 0.025f);
}

/// Small tiles between worktop and wall cupboards; those that a window cuts are left out.
void add_wall_tiles(Pieces& pieces, const Placement& place, float length, const Opening* window) {
  constexpr float kSize = 0.15f, kGap = 0.006f;
  Random random(5);
  const int columns = static_cast<int>(length / kSize);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float x = kSize * static_cast<float>(column), y = kTop + kSize * static_cast<float>(row);
      const u32 material = random.below(9) == 0 ? kWallTileAccent : kWallTile;
      const float along = place.point({x, 0.0f, 0.0f}).x;
      if (window != nullptr && y + kSize > window->y0 - 0.06f && along + kSize > window->a - 0.13f &&
          along < window->b + 0.13f) {
        continue;
      }
      add_box(pieces, place, {x + kGap, y + kGap, 0.0f}, {x + kSize, y + kSize, 0.008f}, material, kFlat);
    }
  }
}

}  // namespace

void add_shell(Pieces& pieces) {
  add_floor(pieces);
  add_window_wall(pieces, Placement::at({0.0f, 0.0f, -kEndZ}), -kSideX, kSideX, kSinkWindow);
  // Along the right wall the place's x is the room's z.
  add_window_wall(pieces, Placement::at({kSideX, 0.0f, 0.0f}, -0.25), -kEndZ, kEndZ, kSideWindow);
  add_quad(pieces, {-kSideX, 0.0f, kEndZ}, {0.0f, 0.0f, -2.0f * kEndZ}, {0.0f, kHeight, 0.0f}, kWall, kFlat);
  add_quad(pieces, {kSideX, 0.0f, kEndZ}, {-2.0f * kSideX, 0.0f, 0.0f}, {0.0f, kHeight, 0.0f}, kWall, kFlat);
  add_quad(pieces, {-kSideX, kHeight, -kEndZ}, {2.0f * kSideX, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f * kEndZ}, kCeiling,
           kFlat);
  const Placement here;
  for (int i = 0; i < 4; ++i) {
    const float z = -2.7f + 1.8f * static_cast<float>(i);
    add_box(pieces, here, {-kSideX, kHeight - 0.26f, z - 0.09f}, {kSideX, kHeight, z + 0.09f}, kWood, kFlat);
  }
  const float skirting = 0.10f;
  add_box(pieces, here, {kSideX - 0.02f, 0.0f, -kEndZ + kOverhang}, {kSideX, skirting, kEndZ}, kTrim, kFlat);
  add_box(pieces, here, {-kSideX, 0.0f, kEndZ - 0.02f}, {kSideX - 0.02f, skirting, kEndZ}, kTrim, kFlat);
  add_wall_tiles(pieces, on_far_wall(-kSideX), 2.0f * kSideX, &kSinkWindow);
  add_wall_tiles(pieces, on_left_wall(1.55f), 1.55f + kEndZ, nullptr);
}

}  // namespace raywalk::kitchen
