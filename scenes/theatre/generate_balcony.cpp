// The balcony over the rear stalls, and boxes on both sides.
#include "scenes/theatre/parts.h"

namespace raywalk::theatre {
namespace {

constexpr float kSlab = 0.30f;  // below the balcony's floor

/// Between two heights on the arc of that radius, from wall to wall, seen from the stage.
void add_face(Pieces& pieces, float radius, float bottom, float top, float bulge, u32 rows, u32 material) {
  const auto face = [=](float u, float v) {
    const float x = kHalfWidth * (1.0f - 2.0f * u);
    const float out = bulge * static_cast<float>(sine_turns(0.5 * v));
    return Vec3{x, bottom + v * (top - bottom), arc_z(radius, x) - out};
  };
  add_sheet(pieces, face, {24, rows}, material);
}

void add_rail(Pieces& pieces, float radius, float height, float thick, u32 material) {
  const auto rail = [=](float u, float v) {
    const float x = kHalfWidth * (1.0f - 2.0f * v);
    const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
    return Vec3{x, height + thick * c, arc_z(radius, x) + thick * s};
  };
  add_sheet(pieces, rail, {6, 24}, material);
}

void add_upper_floor(Pieces& pieces) {
  const float front = kBalconyFront, w = kHalfWidth;
  const auto level = [&](float radius, float height, bool from_above, u32 material) {
    const auto sheet = [=](float u, float v) {
      const float x = w * (2.0f * u - 1.0f), near = arc_z(radius, x);
      const float part = from_above ? v : 1.0f - v;
      return Vec3{x, height, kHalfLength + part * (near - kHalfLength)};
    };
    add_sheet(pieces, sheet, {24, 1}, material);
  };
  level(front, kBalconyFloor - kSlab, false, kPanel);
  level(front, kBalconyFloor, true, kCarpet);
  const float second = front + 1.75f;
  level(second, kBalconyFloor + kBalconyRise, true, kCarpet);
  add_face(pieces, second, kBalconyFloor, kBalconyFloor + kBalconyRise, 0.0f, 1, kWood);

  add_face(pieces, front, kBalconyFloor - kSlab, kBalconyFloor + 0.72f, 0.22f, 4, kPanel);
  const auto inside = [=](float u, float v) {
    const float x = w * (2.0f * u - 1.0f);
    return Vec3{x, kBalconyFloor + 0.72f * v, arc_z(front + 0.12f, x)};
  };
  add_sheet(pieces, inside, {24, 1}, kVelvet);
  add_rail(pieces, front + 0.05f, kBalconyFloor + 0.76f, 0.10f, kVelvet);
  add_rail(pieces, front, kBalconyFloor - kSlab, 0.06f, kGold);
  add_rail(pieces, front - 0.10f, kBalconyFloor + 0.52f, 0.04f, kGold);
  add_rail(pieces, front + 0.05f, kBalconyFloor + 1.0f, 0.022f, kBrass);
  // Shields on the parapet.
  for (int i = -4; i <= 4; ++i) {
    const double turns = 0.0125 * i;
    const float radius = front - 0.22f;
    const Placement place = Placement::at({radius * static_cast<float>(sine_turns(turns)), kBalconyFloor + 0.18f,
                                           kAxisZ + radius * static_cast<float>(cosine_turns(turns))},
                                          turns + 0.5);
    add_pad(pieces, place, {}, {0.30f, 0.16f, 0.05f}, 0.045f, kGold);
  }
  const std::vector<ProfilePoint> column = {{0.24f, 0.0f},  {0.24f, 0.08f}, {0.17f, 0.16f}, {0.15f, 0.9f},
                                            {0.13f, 1.55f}, {0.19f, 1.68f}, {0.26f, 1.85f}};
  for (const float x : {-5.3f, 5.3f}) {
    const float z = arc_z(front + 1.9f, x), floor = row_floor(8);
    std::vector<ProfilePoint> fitted = column;
    for (ProfilePoint& p : fitted) p.height *= (kBalconyFloor - kSlab - floor) / 1.85f;
    add_lathe(pieces, Placement::at({x, floor, z}), fitted, 12, kGold);
  }
}

/// A box on the side wall: a half-round balcony with a rail, curtains and a canopy.
void add_box_seat(Pieces& pieces, float side, float z, float floor) {
  const Placement place = Placement::at({side * kHalfWidth, floor, z}, side < 0.0f ? 0.25 : -0.25);
  const auto round = [](float u, float radius) {
    const double turns = 0.5 * u;
    return Vec3{1.15f * static_cast<float>(cosine_turns(turns)) * (radius / 0.9f), 0.0f,
                radius * static_cast<float>(sine_turns(turns))};
  };
  const auto surface = [&](auto shape, Cells cells, u32 material) {
    add_sheet(
        pieces, [=](float u, float v) { return place.point(shape(1.0f - u, v)); }, cells, material);
  };
  // From the bracket below over the bulging front to the rail.
  surface(
      [=](float u, float v) {
        const float out = v < 0.5f ? 0.25f + 1.36f * v : 0.93f - 0.06f * (v - 0.5f);
        return round(u, out) + Vec3{0.0f, -0.55f + 1.3f * v, 0.0f};
      },
      {16, 5}, kPanel);
  surface([=](float u, float v) { return round(u, 0.9f * (1.0f - v) + 0.01f); }, {16, 1}, kCarpet);
  const auto rail = [&](float height, float radius, float thick, u32 material) {
    surface(
        [=](float u, float v) {
          const float c = static_cast<float>(cosine_turns(v)), s = static_cast<float>(sine_turns(v));
          return round(u, radius + thick * c) + Vec3{0.0f, height + thick * s, 0.0f};
        },
        {12, 5}, material);
  };
  rail(0.78f, 0.92f, 0.06f, kVelvet);
  rail(0.30f, 0.95f, 0.035f, kGold);
  for (const float end : {-1.0f, 1.0f}) {
    surface(
        [=](float u, float v) {
          const float fold = static_cast<float>(sine_turns(4.0 * u));
          const float pinch = v < 0.4f ? 1.0f - 1.4f * v : 0.44f + 0.93f * (v - 0.4f);
          return Vec3{end * (1.15f - 0.55f * pinch * u), 2.3f * v, 0.10f + 0.05f * fold};
        },
        {20, 3}, kVelvet);
  }
  surface(
      [=](float u, float v) {
        const float scallop = 0.12f * static_cast<float>(cosine_turns(5.0 * u));
        return round(u, 0.45f + 0.03f * static_cast<float>(sine_turns(12.0 * u))) +
               Vec3{0.0f, 2.0f + scallop + (0.5f - scallop) * v, 0.0f};
      },
      {30, 2}, kVelvet);
  const Vec3 corner = place.point({-1.1f, 0.0f, 0.03f});
  add_plate(pieces, corner, place.direction({2.2f, 0.0f, 0.0f}), {0.0f, 2.4f, 0.0f}, kBackdrop);
}

}  // namespace

void add_balcony(Pieces& pieces) {
  add_upper_floor(pieces);
  for (const float side : {-1.0f, 1.0f}) {
    for (const float z : {-3.4f, -0.35f}) add_box_seat(pieces, side, z, 3.3f);
  }
}

}  // namespace raywalk::theatre
