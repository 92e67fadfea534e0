// The hall: a tiled floor, two rows of columns, a ribbed vault over the nave and flat aisles.
#include "scenes/museum/parts.h"

namespace raywalk::museum {
namespace {

void add_floor(Pieces& pieces) {
  constexpr int kColumns = 10, kRows = 15;
  const float width = 2.0f * kSideX / kColumns, depth = 2.0f * kEndZ / kRows;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const float x = -kSideX + width * static_cast<float>(column), z = -kEndZ + depth * static_cast<float>(row + 1);
      add_quad(pieces, {x, 0.0f, z}, {width, 0.0f, 0.0f}, {0.0f, 0.0f, -depth},
               (row + column) % 2 ? kDarkTile : kLightTile, kFlat);
    }
  }
}

void add_walls(Pieces& pieces) {
  const Placement here;
  const Vec3 up = {0.0f, kSpringing, 0.0f};
  add_quad(pieces, {-kSideX, 0.0f, kEndZ}, {0.0f, 0.0f, -2.0f * kEndZ}, up, kWall, kFlat);
  add_quad(pieces, {kSideX, 0.0f, -kEndZ}, {0.0f, 0.0f, 2.0f * kEndZ}, up, kWall, kFlat);
  add_quad(pieces, {-kSideX, 0.0f, -kEndZ}, {2.0f * kSideX, 0.0f, 0.0f}, up, kWall, kFlat);
  add_quad(pieces, {kSideX, 0.0f, kEndZ}, {-2.0f * kSideX, 0.0f, 0.0f}, up, kWall, kFlat);
  // Dado and cornice all around, one above the other.
  const auto band = [&](float y0, float y1, float proud, u32 material) {
    for (const float side : {-1.0f, 1.0f}) {
      const float x = side * (kSideX - 0.5f * proud), z = side * (kEndZ - 0.5f * proud);
      add_box(pieces, here, {x - 0.5f * proud, y0, -kEndZ}, {x + 0.5f * proud, y1, kEndZ}, material, kFlat);
      add_box(pieces, here, {-kSideX + proud, y0, z - 0.5f * proud}, {kSideX - proud, y1, z + 0.5f * proud}, material,
              kFlat);
    }
  };
  band(0.0f, 0.18f, 0.05f, kDarkTile);
  band(0.18f, 0.86f, 0.02f, kDado);
  band(0.86f, 0.92f, 0.04f, kGold);
  band(kSpringing - 0.30f, kSpringing - 0.16f, 0.06f, kPlaster);
  band(kSpringing - 0.16f, kSpringing, 0.12f, kPlaster);
}

void add_columns(Pieces& pieces) {
  // Mouldings and shaft apart, so that each has rows where it curves.
  const std::vector<ProfilePoint> foot = {{0.30f, 0.12f}, {0.335f, 0.155f}, {0.30f, 0.19f}, {0.262f, 0.22f}};
  const std::vector<ProfilePoint> shaft = {{0.262f, 0.22f}, {0.262f, 1.30f}, {0.250f, 2.50f}, {0.222f, 3.76f}};
  const std::vector<ProfilePoint> head = {{0.222f, 3.76f}, {0.250f, 3.79f}, {0.222f, 3.82f}, {0.300f, 4.00f}};
  for (const float x : {-kRowX, kRowX}) {
    for (int i = -2; i <= 2; ++i) {
      const Placement place = Placement::at({x, 0.0f, kBay * static_cast<float>(i)});
      add_box(pieces, place, {-0.36f, 0.0f, -0.36f}, {0.36f, 0.12f, 0.36f}, kMarble, kFlat);
      add_turned(pieces, place, foot, kMarble, kFine);
      add_turned(pieces, place, shaft, kMarble, kCurved);
      add_turned(pieces, place, head, kMarble, kFine);
      add_box(pieces, place, {-0.33f, 4.00f, -0.33f}, {0.33f, 4.12f, 0.33f}, kMarble, kFlat);
    }
    // What they carry.
    add_box(pieces, {}, {x - 0.28f, 4.12f, -kEndZ}, {x + 0.28f, kSpringing - 0.1f, kEndZ}, kPlaster, kFlat);
    add_box(pieces, {}, {x - 0.34f, kSpringing - 0.1f, -kEndZ}, {x + 0.34f, kSpringing, kEndZ}, kPlaster, kFlat);
  }
}

/// Half an ellipse across the nave: u from the right to the left springing, seen from below.
SurfacePoint on_vault(float u, float z, float inwards) {
  const float c = static_cast<float>(cosine_turns(0.5 * u)), s = static_cast<float>(sine_turns(0.5 * u));
  const float a = kRowX - 0.28f - inwards, b = kCrown - kSpringing - inwards;
  return {{a * c, kSpringing + b * s, z}, normalized({-c / a, -s / b, 0.0f})};
}

void add_vault(Pieces& pieces) {
  constexpr float kArc = 8.0f;
  pieces.patch([](float u, float v) { return on_vault(u, kEndZ - 2.0f * kEndZ * v, 0.0f); }, 2.0f, kPlaster,
               0.15 * kCurved * kArc * 2.0 * kEndZ);
  for (int i = -2; i <= 2; ++i) {
    const float z = kBay * static_cast<float>(i);
    const float half = 0.16f, deep = 0.14f;
    pieces.patch([=](float u, float v) { return on_vault(u, z + half - 2.0f * half * v, deep); }, 20.0f, kMarble,
                 kCurved * kArc * 2.0 * half);
    for (const float side : {-1.0f, 1.0f}) {
      pieces.patch(
          [=](float u, float v) {
            const float across = side > 0.0f ? v : 1.0f - v;
            return SurfacePoint{on_vault(u, z + side * half, deep * across).position, {0.0f, 0.0f, side}};
          },
          20.0f, kMarble, kCurved * kArc * deep);
    }
  }
  // The walls at both ends, from the springing up to the arc.
  for (const float side : {-1.0f, 1.0f}) {
    pieces.patch(
        [=](float u, float v) {
          const Vec3 top = on_vault(side > 0.0f ? 1.0f - u : u, side * kEndZ, 0.0f).position;
          // From the springing upwards, and mirrored at the other end: both are seen from the nave.
          return SurfacePoint{{-top.x, kSpringing + v * (top.y - kSpringing), side * kEndZ}, {0.0f, 0.0f, -side}};
        },
        3.0f, kWall, kCurved * 4.0);
    const float x0 = side > 0.0f ? kRowX - 0.28f : -kSideX, width = kSideX - kRowX + 0.28f;
    add_quad(pieces, {x0, kSpringing, -kEndZ}, {width, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f * kEndZ}, kPlaster, kFlat);
  }
}

}  // namespace

void add_hall(Pieces& pieces) {
  add_floor(pieces);
  add_walls(pieces);
  add_columns(pieces);
  add_vault(pieces);
}

}  // namespace raywalk::museum
