// The house: walls with pilasters and panels, the ceiling's rosette, the stepped floor, doors.
#include "scenes/theatre/parts.h"

namespace raywalk::theatre {
namespace {

void add_walls(Pieces& pieces) {
  const float x = kHalfWidth, z = kHalfLength, y = kHeight;
  add_plate(pieces, {-x, 0.0f, z}, {0.0f, 0.0f, -2.0f * z}, {0.0f, y, 0.0f}, kWall);
  add_plate(pieces, {x, 0.0f, -z}, {0.0f, 0.0f, 2.0f * z}, {0.0f, y, 0.0f}, kWall);
  add_plate(pieces, {x, 0.0f, z}, {-2.0f * x, 0.0f, 0.0f}, {0.0f, y, 0.0f}, kWall);
  add_plate(pieces, {-x, 0.0f, -z}, {2.0f * x, 0.0f, 0.0f}, {0.0f, y, 0.0f}, kWall);
  add_plate(pieces, {-x, y, -z}, {2.0f * x, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f * z}, kCeiling);
}

/// A wall's frame of mouldings around a panel; the place looks out of the wall.
void add_panel(Pieces& pieces, const Placement& place, float width, float height, u32 inside) {
  const float x = 0.5f * width, f = 0.07f;
  add_block(pieces, place, {-x, 0.0f, 0.0f}, {x, f, 0.05f}, kGold);
  add_block(pieces, place, {-x, height - f, 0.0f}, {x, height, 0.05f}, kGold);
  add_block(pieces, place, {-x, f, 0.0f}, {-x + f, height - f, 0.05f}, kGold);
  add_block(pieces, place, {x - f, f, 0.0f}, {x, height - f, 0.05f}, kGold);
  add_plate(pieces, place.point({-x + f, f, 0.02f}), place.direction({width - 2.0f * f, 0.0f, 0.0f}),
            {0.0f, height - 2.0f * f, 0.0f}, inside);
}

/// Pilasters with base and capital, between them panels, below a dado of wood.
void add_side(Pieces& pieces, float side) {
  const double turns = side < 0.0f ? 0.25 : -0.25;
  const auto at = [&](float y, float z) { return Placement::at({side * kHalfWidth, y, z}, turns); };
  const float first = -4.9f, pitch = 3.05f;
  for (int i = 0; i < 5; ++i) {
    const float z = first + pitch * static_cast<float>(i);
    const Placement pilaster = at(0.0f, z);
    add_block(pieces, pilaster, {-0.24f, 0.0f, 0.0f}, {0.24f, 7.2f, 0.14f}, kPanel);
    add_block(pieces, pilaster, {-0.30f, 7.0f, 0.0f}, {0.30f, 7.45f, 0.22f}, kGold);
    add_block(pieces, pilaster, {-0.29f, 1.35f, 0.0f}, {0.29f, 1.55f, 0.20f}, kGold);
    // The boxes stand in the first two bays, and the balcony crosses the last one.
    const Placement bay = at(i == 2 ? 2.0f : 5.2f, z + 0.5f * pitch);
    if (i == 2) add_panel(pieces, bay, pitch - 0.9f, 4.6f, kMirror);
    if (i == 3) add_panel(pieces, bay, pitch - 0.9f, 1.4f, kPanel);
  }
  const float end = kHalfLength;
  add_block(pieces, at(0.0f, 0.5f * (end + kProscenium)), {-0.5f * (end - kProscenium), 0.0f, 0.0f},
            {0.5f * (end - kProscenium), 1.4f, 0.06f}, kWood);
  // The cornice: a quarter round under the ceiling, all along the house.
  const auto cornice = [=](float u, float v) {
    const float c = static_cast<float>(cosine_turns(0.25 * v)), s = static_cast<float>(sine_turns(0.25 * v));
    const float out = 0.55f * (1.0f - c), down = 0.5f * (1.0f - s);
    const float along = side < 0.0f ? 1.0f - u : u;
    return Vec3{side * (kHalfWidth - out), kHeight - down, kProscenium + along * (end - kProscenium)};
  };
  add_sheet(pieces, cornice, {12, 6}, kPanel);
}

/// Rings of plaster and petals around the chandelier's hook.
void add_rosette(Pieces& pieces) {
  const Vec3 hook = {0.0f, kHeight, 0.8f};
  const auto ring = [&](float radius, float thick) {
    const std::vector<ProfilePoint> profile = {{radius - thick, 0.0f},
                                               {radius - 0.5f * thick, -0.8f * thick},
                                               {radius, -thick},
                                               {radius + 0.5f * thick, -0.8f * thick},
                                               {radius + thick, 0.0f}};
    add_lathe(pieces, Placement::at(hook), profile, 36, kGold);
  };
  ring(3.3f, 0.12f);
  ring(1.1f, 0.09f);
  const auto petals = [=](float u, float v) {
    const float wave = 0.5f + 0.5f * static_cast<float>(cosine_turns(16.0 * u));
    const float radius = 1.25f + 1.7f * v * (0.75f + 0.25f * wave);
    const float down = 0.16f * wave * static_cast<float>(sine_turns(0.5 * v));
    return hook + Vec3{radius * static_cast<float>(cosine_turns(u)), -0.01f - down,
                       radius * static_cast<float>(sine_turns(u))};
  };
  add_sheet(pieces, petals, {64, 4}, kPanel);
}

/// Steps along the arcs, each beginning half a pitch before its seats; the last one reaches the rear wall.
void add_floor(Pieces& pieces) {
  const float w = kHalfWidth;
  add_plate(pieces, {-w, 0.0f, 0.0f}, {2.0f * w, 0.0f, 0.0f}, {0.0f, 0.0f, kProscenium}, kCarpet);
  for (int row = 1; row < kRows; ++row) {
    const float height = row_floor(row), riser = height - row_floor(row - 1);
    const float from = kFirstRow + kRowPitch * (static_cast<float>(row) - 0.5f);
    const bool last = row + 1 == kRows;
    const auto tread = [=](float u, float v) {
      const float x = w * (2.0f * u - 1.0f);
      const float near = arc_z(from, x), far = last ? kHalfLength : arc_z(from + kRowPitch, x);
      return Vec3{x, height, far + v * (near - far)};
    };
    add_sheet(pieces, tread, {16, 1}, kCarpet);
    const auto face = [=](float u, float v) {
      const float x = w * (1.0f - 2.0f * u);
      return Vec3{x, height - riser * (1.0f - v), arc_z(from, x)};
    };
    add_sheet(pieces, face, {16, 1}, kWood);
  }
}

void add_doors(Pieces& pieces) {
  const float floor = row_floor(kRows - 1);
  for (const float x : {-4.2f, 4.2f}) {
    const Placement place = Placement::at({x, floor, kHalfLength}, 0.5);
    for (const float side : {-1.0f, 1.0f}) {
      const float near = 0.02f * side, far = 0.72f * side;
      add_block(pieces, place, {smaller(near, far), 0.0f, 0.0f}, {larger(near, far), 1.72f, 0.05f}, kDoor);
      add_pad(pieces, place, {0.37f * side, 1.2f, 0.05f}, {0.24f, 0.36f, 0.02f}, 0.018f, kDoor);
      add_pad(pieces, place, {0.37f * side, 0.42f, 0.05f}, {0.24f, 0.28f, 0.02f}, 0.018f, kDoor);
      add_tube(pieces, place,
               {{0.09f * side, 0.75f, 0.05f},
                {0.09f * side, 0.78f, 0.11f},
                {0.09f * side, 1.02f, 0.11f},
                {0.09f * side, 1.05f, 0.05f}},
               0.014f, {6, 6}, kBrass);
    }
    add_block(pieces, place, {-0.86f, 0.0f, 0.0f}, {-0.73f, 1.78f, 0.09f}, kGold);
    add_block(pieces, place, {0.73f, 0.0f, 0.0f}, {0.86f, 1.78f, 0.09f}, kGold);
    add_block(pieces, place, {-0.73f, 1.73f, 0.0f}, {0.73f, 1.78f, 0.09f}, kGold);
  }
}

}  // namespace

void add_house(Pieces& pieces) {
  add_walls(pieces);
  add_side(pieces, -1.0f);
  add_side(pieces, 1.0f);
  add_rosette(pieces);
  add_floor(pieces);
  add_doors(pieces);
}

}  // namespace raywalk::theatre
