// The room itself: carpet, walls with wood panels, double door.
#include "scenes/conference/parts.h"

namespace raywalk::conference {
namespace {

void add_floor(Pieces& pieces) {
  constexpr int kColumns = 20, kRows = 13;
  const float width = 2.0f * kHalfLength / kColumns, depth = 2.0f * kHalfDepth / kRows;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const bool border = row == 1 || row == kRows - 2 || column == 1 || column == kColumns - 2;
      const bool outside = row == 0 || row == kRows - 1 || column == 0 || column == kColumns - 1;
      add_plate(
          pieces,
          {-kHalfLength + width * static_cast<float>(column), 0.0f, -kHalfDepth + depth * static_cast<float>(row + 1)},
          {width, 0.0f, 0.0f}, {0.0f, 0.0f, -depth}, border && !outside ? kCarpetBorder : kCarpet);
    }
  }
}

/// Raised panels in two heights between stiles, along local x from 0 to `length`.
void add_panelling(Pieces& pieces, const Placement& place, float length, int bays) {
  const float pitch = length / static_cast<float>(bays);
  add_block(pieces, place, {0.0f, 0.0f, 0.0f}, {length, 0.14f, 0.045f}, kShell);
  add_block(pieces, place, {0.0f, 0.95f, 0.0f}, {length, 1.03f, 0.05f}, kShell);
  add_block(pieces, place, {0.0f, 2.62f, 0.0f}, {length, 2.74f, 0.05f}, kShell);
  add_plate(pieces, place.point({0.0f, 0.14f, 0.005f}), place.direction({length, 0.0f, 0.0f}), {0.0f, 2.48f, 0.0f},
            kShell);
  for (int i = 0; i < bays; ++i) {
    const float x = pitch * static_cast<float>(i), middle = x + 0.5f * pitch, half = 0.5f * pitch - 0.09f;
    add_block(pieces, place, {x, 0.14f, 0.0f}, {x + 0.05f, 2.62f, 0.035f}, kShell);
    add_pad(pieces, place, {middle + 0.025f, 0.545f, 0.012f}, {half, 0.34f, 0.022f}, 0.02f, kPanel, 2);
    add_pad(pieces, place, {middle + 0.025f, 1.825f, 0.012f}, {half, 0.73f, 0.022f}, 0.02f, kPanel, 2);
  }
}

void add_walls(Pieces& pieces) {
  const float x = kHalfLength, z = kHalfDepth;
  add_plate(pieces, {x, 0.0f, z}, {-2.0f * x, 0.0f, 0.0f}, {0.0f, kHeight, 0.0f}, kWall);
  add_plate(pieces, {-x, 0.0f, z}, {0.0f, 0.0f, -2.0f * z}, {0.0f, kHeight, 0.0f}, kWall);
  add_plate(pieces, {x, 0.0f, -z}, {0.0f, 0.0f, 2.0f * z}, {0.0f, kHeight, 0.0f}, kWall);
  // The door's wall and the sideboard's are panelled.
  add_panelling(pieces, Placement::at({x, 0.0f, z}, 0.5), x - 4.55f, 2);
  add_panelling(pieces, Placement::at({2.65f, 0.0f, z}, 0.5), 2.65f + x, 9);
  add_panelling(pieces, Placement::at({x, 0.0f, -z}, -0.25), 2.0f * z, 8);
  add_block(pieces, Placement::at({-x, 0.0f, z}, 0.25), {0.0f, 0.0f, 0.0f}, {2.0f * z, 0.12f, 0.02f}, kShell);
}

void add_door(Pieces& pieces) {
  const Placement place = Placement::at({3.6f, 0.0f, kHalfDepth}, 0.5);
  for (const float side : {-1.0f, 1.0f}) {
    const float near = 0.004f * side, far = 0.83f * side;
    add_block(pieces, place, {smaller(near, far), 0.005f, 0.0f}, {larger(near, far), 2.2f, 0.05f}, kTable);
    for (int i = 0; i < 3; ++i) {
      add_pad(pieces, place, {0.415f * side, 0.42f + 0.68f * static_cast<float>(i), 0.05f}, {0.29f, 0.28f, 0.02f},
              0.018f, kTable, 3);
    }
    add_tube(pieces, place,
             {{0.09f * side, 0.85f, 0.05f},
              {0.09f * side, 0.87f, 0.11f},
              {0.09f * side, 1.05f, 0.12f},
              {0.09f * side, 1.23f, 0.11f},
              {0.09f * side, 1.25f, 0.05f}},
             0.014f, {16, 32}, kBrass);
    for (const float y : {0.3f, 1.1f, 1.9f}) {
      add_lathe(pieces, place.inner({0.84f * side, y, 0.055f}), {{0.012f, -0.06f}, {0.012f, 0.06f}}, 16, kBrass);
    }
    const float a = 0.83f * side, b = 0.94f * side;
    add_block(pieces, place, {smaller(a, b), 0.0f, 0.0f}, {larger(a, b), 2.32f, 0.08f}, kShell);
  }
  add_block(pieces, place, {-0.83f, 2.2f, 0.0f}, {0.83f, 2.32f, 0.08f}, kShell);
  add_pad(pieces, place, {0.0f, 2.45f, 0.03f}, {0.24f, 0.075f, 0.025f}, 0.02f, kGreen, 2);
}

}  // namespace

void add_shell(Pieces& pieces) {
  add_floor(pieces);
  add_walls(pieces);
  add_door(pieces);
}

}  // namespace raywalk::conference
