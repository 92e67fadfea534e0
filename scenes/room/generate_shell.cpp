// The room itself: planks, walls with a window, skirting, mirror and pictures.
#include "scenes/room/parts.h"

namespace raywalk::room {
namespace {

void add_floor(Pieces& pieces) {
  constexpr int kRows = 25;
  constexpr float kWidth = (kBackZ - kFrontZ) / kRows;
  Random random(7);
  for (int row = 0; row < kRows; ++row) {
    float x = kLeftX;
    float end = kLeftX + random.between(0.5f, 1.6f);
    while (x < kRightX) {
      if (kRightX - end < 0.4f) end = kRightX;
      const u32 material = kPlankLight + random.below(3);
      add_quad(pieces, {x, 0.0f, kFrontZ + static_cast<float>(row + 1) * kWidth}, {end - x, 0.0f, 0.0f},
               {0.0f, 0.0f, -kWidth}, material, kFlat);
      x = end;
      end += random.between(1.0f, 1.8f);
    }
  }
}

/// The far wall (z = kFrontZ, seen at the end of the walk's first view) has the window.
void add_walls(Pieces& pieces) {
  const float width = kRightX - kLeftX, depth = kBackZ - kFrontZ;
  const auto far_wall = [&](float x0, float y0, float x1, float y1) {
    add_quad(pieces, {x0, y0, kFrontZ}, {x1 - x0, 0.0f, 0.0f}, {0.0f, y1 - y0, 0.0f}, kAccentWall, kFlat);
  };
  far_wall(kLeftX, 0.0f, kWindow.x0, kHeight);
  far_wall(kWindow.x1, 0.0f, kRightX, kHeight);
  far_wall(kWindow.x0, 0.0f, kWindow.x1, kWindow.y0);
  far_wall(kWindow.x0, kWindow.y1, kWindow.x1, kHeight);
  add_quad(pieces, {kRightX, 0.0f, kBackZ}, {-width, 0.0f, 0.0f}, {0.0f, kHeight, 0.0f}, kWall, kFlat);
  add_quad(pieces, {kLeftX, 0.0f, kBackZ}, {0.0f, 0.0f, -depth}, {0.0f, kHeight, 0.0f}, kWall, kFlat);
  add_quad(pieces, {kRightX, 0.0f, kFrontZ}, {0.0f, 0.0f, depth}, {0.0f, kHeight, 0.0f}, kWall, kFlat);
  add_quad(pieces, {kLeftX, kHeight, kFrontZ}, {width, 0.0f, 0.0f}, {0.0f, 0.0f, depth}, kCeiling, kFlat);
}

void add_trim(Pieces& pieces) {
  const Placement here;
  const float skirting = 0.09f, thick = 0.015f;
  add_box(pieces, here, {kLeftX, 0.0f, kFrontZ}, {kRightX, skirting, kFrontZ + thick}, kTrim, kFlat);
  add_box(pieces, here, {kLeftX, 0.0f, kBackZ - thick}, {kRightX, skirting, kBackZ}, kTrim, kFlat);
  add_box(pieces, here, {kLeftX, 0.0f, kFrontZ}, {kLeftX + thick, skirting, kBackZ}, kTrim, kFlat);
  add_box(pieces, here, {kRightX - thick, 0.0f, kFrontZ}, {kRightX, skirting, kBackZ}, kTrim, kFlat);

  const auto bar = [&](float x0, float y0, float x1, float y1) {
    add_box(pieces, here, {x0, y0, kFrontZ - 0.12f}, {x1, y1, kFrontZ + 0.02f}, kTrim, kFlat);
  };
  const float f = 0.06f, middle_x = 0.5f * (kWindow.x0 + kWindow.x1),
              middle_y = kWindow.y0 + 0.62f * (kWindow.y1 - kWindow.y0);
  bar(kWindow.x0 - f, kWindow.y0 - f, kWindow.x0, kWindow.y1 + f);
  bar(kWindow.x1, kWindow.y0 - f, kWindow.x1 + f, kWindow.y1 + f);
  bar(kWindow.x0, kWindow.y1, kWindow.x1, kWindow.y1 + f);
  bar(kWindow.x0, kWindow.y0 - f, kWindow.x1, kWindow.y0);
  bar(middle_x - 0.02f, kWindow.y0, middle_x + 0.02f, kWindow.y1);
  bar(kWindow.x0, middle_y - 0.02f, kWindow.x1, middle_y + 0.02f);
  add_box(pieces, here, {kWindow.x0 - 0.1f, kWindow.y0 - 0.1f, kFrontZ},
          {kWindow.x1 + 0.1f, kWindow.y0 - f, kFrontZ + 0.18f}, kTrim, kFlat);
}

/// A framed rectangle that stands off a wall: local x to the right, y up, z out of the wall.
void add_framed(Pieces& pieces, const Placement& place, float width, float height, u32 frame, u32 inside) {
  const float f = 0.05f, x = 0.5f * width, deep = 0.035f;
  add_box(pieces, place, {-x - f, -f, 0.0f}, {-x, height + f, deep}, frame, kFlat);
  add_box(pieces, place, {x, -f, 0.0f}, {x + f, height + f, deep}, frame, kFlat);
  add_box(pieces, place, {-x, -f, 0.0f}, {x, 0.0f, deep}, frame, kFlat);
  add_box(pieces, place, {-x, height, 0.0f}, {x, height + f, deep}, frame, kFlat);
  add_quad(pieces, place.point({-x, 0.0f, 0.015f}), place.direction({width, 0.0f, 0.0f}), {0.0f, height, 0.0f}, inside,
           kFlat);
}

}  // namespace

void add_shell(Pieces& pieces) {
  add_floor(pieces);
  add_walls(pieces);
  add_trim(pieces);
  add_framed(pieces, Placement::at({-0.75f, 0.85f, kFrontZ}), 1.5f, 1.3f, kBronze, kMirror);
  add_framed(pieces, Placement::at({0.3f, 1.20f, kBackZ}, 0.5), 1.7f, 0.9f, kWood, kAccentWall);
  const u32 canvases[] = {kBookBlue, kOrange, kBookGreen};
  for (int i = 0; i < 3; ++i) {
    const float z = 1.0f - 0.8f * static_cast<float>(i);
    const Placement place = Placement::at({kLeftX, 1.45f, z}, 0.25);
    add_framed(pieces, place, 0.5f, 0.62f, kTrim, kBookCream);
    add_quad(pieces, place.point({-0.14f, 0.12f, 0.017f}), place.direction({0.28f, 0.0f, 0.0f}), {0.0f, 0.38f, 0.0f},
             canvases[i], kFlat);
  }
}

}  // namespace raywalk::room
