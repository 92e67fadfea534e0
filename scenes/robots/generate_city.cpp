// The street between tall buildings, the square on its left side and the tower at its end.
#include <vector>

#include "scenes/robots/parts.h"

namespace raywalk::robots {
namespace {

/// A grid of windows on one face: `corner` is its lower left, `right` along it, `out` away from it (unit length).
void add_windows(Pieces& pieces, Vec3 corner, Vec3 right, float height, Vec3 out, int columns, int storeys) {
  const float pitch = height / static_cast<float>(storeys);
  const Vec3 start = corner + 0.12f * out;
  for (int i = 0; i < storeys; ++i) {
    const Vec3 low = start + Vec3{0.0f, pitch * (static_cast<float>(i) + 0.28f), 0.0f} + 0.04f * right;
    add_quad(pieces, low, 0.92f * right, {0.0f, 0.55f * pitch, 0.0f}, kWindow, kFlat);
  }
  const Vec3 step = right * (1.0f / static_cast<float>(columns)), half = normalized(right) * 0.9f;
  for (int i = 0; i <= columns; ++i) {
    const Vec3 middle = corner + 0.04f * right + (0.92f * static_cast<float>(i)) * step;
    add_slab(pieces, middle + Vec3{0.0f, 0.5f * height, 0.0f} + 0.6f * out, half, {0.0f, 0.48f * height, 0.0f},
             0.6f * out, kTrim, kFlat);
  }
}

struct Lot {
  float z0, z1, setback, height;
  u32 wall;
};

/// On the right side of the street for side = 1, on the left for -1.
void add_building(Pieces& pieces, const Lot& lot, float side) {
  const float inner = kFacadeX + lot.setback, x0 = side > 0.0f ? inner : -kSideX, x1 = side > 0.0f ? kSideX : -inner;
  const Placement here;
  add_box(pieces, here, {x0, 0.0f, lot.z0}, {x1, lot.height, lot.z1}, lot.wall, kFlat);
  const Vec3 facade = {side * inner, 14.0f, side > 0.0f ? lot.z0 : lot.z1};
  const float width = lot.z1 - lot.z0, tall = lot.height - 18.0f;
  const int storeys = static_cast<int>(tall / 11.0f), columns = static_cast<int>(width / 14.0f);
  const Vec3 out = {-side, 0.0f, 0.0f};
  add_windows(pieces, facade, {0.0f, 0.0f, side * width}, tall, out, columns, storeys);
  // The side that looks down the street, where the neighbour is lower or further back.
  add_windows(pieces, {x0, 14.0f, lot.z1}, {x1 - x0, 0.0f, 0.0f}, tall, {0.0f, 0.0f, 1.0f}, 5, storeys);
  // Plinth with shop windows, a ledge above them, a parapet and something on the roof.
  const Joint street = {{side * inner, 0.0f, 0.5f * (lot.z0 + lot.z1)}, {0.0f, 0.0f, side}, {0.0f, 1.0f, 0.0f}, out};
  const float half = 0.5f * width;
  add_block(pieces, street, {-half, 11.5f, 0.0f}, {half, 13.0f, 2.2f}, kTrim);
  const int shops = columns > 1 ? columns : 1;
  for (int i = 0; i < shops; ++i) {
    const float a = -half + width * (static_cast<float>(i) + 0.12f) / static_cast<float>(shops);
    const float b = -half + width * (static_cast<float>(i) + 0.88f) / static_cast<float>(shops);
    add_quad(pieces, street.point({a, 1.8f, 0.15f}), street.direction({b - a, 0.0f, 0.0f}), {0.0f, 7.6f, 0.0f}, kWindow,
             kFlat);
  }
  add_box(pieces, here, {x0, lot.height, lot.z0}, {x1, lot.height + 2.5f, lot.z0 + 2.0f}, kTrim, kFlat);
  add_box(pieces, here, {x0, lot.height, lot.z1 - 2.0f}, {x1, lot.height + 2.5f, lot.z1}, kTrim, kFlat);
  add_box(pieces, here, {0.5f * (x0 + x1) - 14.0f, lot.height, lot.z0 + 0.3f * width},
          {0.5f * (x0 + x1) + 12.0f, lot.height + 12.0f, lot.z0 + 0.6f * width}, kRoof, kFlat);
}

/// Two legs, a body above the street that narrows twice, and a needle.
void add_tower(Pieces& pieces) {
  const Placement here;
  const float z0 = -kEndZ, z1 = -250.0f;
  for (const float side : {-1.0f, 1.0f}) {
    const float x0 = side > 0.0f ? 30.0f : -80.0f;
    add_box(pieces, here, {x0, 0.0f, z0}, {x0 + 50.0f, 70.0f, z1}, kSlate, kFlat);
    add_windows(pieces, {x0, 10.0f, z1}, {50.0f, 0.0f, 0.0f}, 56.0f, {0.0f, 0.0f, 1.0f}, 4, 5);
  }
  const float half[] = {80.0f, 62.0f, 40.0f}, top[] = {190.0f, 330.0f, 440.0f};
  float bottom = 70.0f;
  for (int i = 0; i < 3; ++i) {
    const float front = z1 - 9.0f * static_cast<float>(i);
    add_box(pieces, here, {-half[i], bottom, z0}, {half[i], top[i], front}, kSlate, kFlat);
    add_windows(pieces, {-half[i], bottom + 4.0f, front}, {2.0f * half[i], 0.0f, 0.0f}, top[i] - bottom - 8.0f,
                {0.0f, 0.0f, 1.0f}, 9, 10);
    bottom = top[i];
  }
  add_turned(pieces, Placement::at({0.0f, bottom, -300.0f}),
             {{22.0f, 0.0f}, {20.0f, 14.0f}, {8.0f, 26.0f}, {3.0f, 52.0f}, {1.2f, 76.0f}, {0.1f, kTower - bottom}},
             kSteel, 0.02);
}

void add_lamp_post(Pieces& pieces, Vec3 at, float side) {
  add_turned(pieces, Placement::at(at), {{0.9f, 0.0f}, {0.8f, 1.2f}, {0.35f, 1.8f}, {0.28f, 12.0f}, {0.22f, 22.0f}},
             kSteel, kPlain);
  add_rod(pieces, at + Vec3{0.0f, 21.8f, 0.0f}, at + Vec3{-5.0f * side, 23.2f, 0.0f}, 0.22f, kSteel, kPlain);
  add_sphere(pieces, at + Vec3{-5.0f * side, 22.9f, 0.0f}, 0.9f, kLamp, kPlain);
}

void add_street(Pieces& pieces) {
  const Placement here;
  add_quad(pieces, {-kSideX, 0.0f, kEndZ}, {2.0f * kSideX, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f * kEndZ}, kAsphalt, kFlat);
  for (const float side : {-1.0f, 1.0f}) {
    const float x0 = side > 0.0f ? kStreetX : -kFacadeX, x1 = side > 0.0f ? kFacadeX : -kStreetX;
    for (const auto& [z0, z1] : {std::pair{-kEndZ, -44.0f}, std::pair{74.0f, kEndZ}}) {
      add_box(pieces, here, {x0, 0.0f, z0}, {x1, kKerb, z1}, kPavement, kFlat);
    }
    if (side > 0.0f) add_box(pieces, here, {x0, 0.0f, -44.0f}, {x1, kKerb, 74.0f}, kPavement, kFlat);
    for (int i = 0; i < 6; ++i) {
      const float z = -230.0f + 88.0f * static_cast<float>(i);
      if (side < 0.0f && z > -44.0f && z < 74.0f) continue;
      add_lamp_post(pieces, {side * (kStreetX + 3.0f), kKerb, z}, side);
    }
  }
  for (int i = 0; i < 24; ++i) {
    const float z = kEndZ - 16.0f - 26.0f * static_cast<float>(i);
    add_quad(pieces, {-0.7f, 0.03f, z}, {1.4f, 0.0f, 0.0f}, {0.0f, 0.0f, -13.0f}, kMarking, kFlat);
  }
  for (int i = 0; i < 9; ++i) {
    const float x = -31.0f + 7.0f * static_cast<float>(i);
    add_quad(pieces, {x, 0.03f, 128.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -14.0f}, kMarking, kFlat);
  }
}

/// Paved in two colours, with a ring of chrome on a base and bowls of green around it.
void add_square(Pieces& pieces) {
  constexpr int kColumns = 8, kRows = 8;
  const float x0 = -114.0f, z0 = -44.0f, width = (-kStreetX - x0) / kColumns, depth = 118.0f / kRows;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const float x = x0 + width * static_cast<float>(i % kColumns),
                z = z0 + depth * static_cast<float>(i / kColumns + 1);
    add_quad(pieces, {x, 0.04f, z}, {width, 0.0f, 0.0f}, {0.0f, 0.0f, -depth},
             (i + i / kColumns) % 2 ? kPavement : kSandstone, kFlat);
  }
  const Vec3 middle = {-76.0f, 0.0f, 16.0f};
  add_turned(pieces, Placement::at(middle), {{17.0f, 0.0f}, {17.0f, 0.9f}, {16.6f, 1.1f}, {0.01f, 1.1f}}, kConcrete,
             kPlain);
  add_turned(pieces, Placement::at(middle), {{7.0f, 1.0f}, {6.0f, 3.0f}, {4.0f, 4.2f}, {0.01f, 4.6f}}, kSlate, kPlain);
  add_ring(pieces, middle + Vec3{0.0f, 21.0f, 0.0f}, normalized({0.5f, 0.15f, 1.0f}), 15.0f, 2.2f, kChrome, 0.8);
  const std::vector<ProfilePoint> bowl = {{1.6f, 0.0f}, {2.6f, 1.2f}, {3.2f, 3.0f}, {2.9f, 3.0f}, {0.01f, 2.4f}};
  for (int i = 0; i < 6; ++i) {
    const Vec3 at = Placement::at(middle, (i + 0.3) / 6.0).point({25.0f, 0.0f, 0.0f});
    add_turned(pieces, Placement::at(at), bowl, kConcrete, kPlain);
    add_pod(pieces, {at}, {0.0f, 5.0f, 0.0f}, {2.6f, 2.5f, 2.6f}, kLeaf, kPlain);
  }
}

}  // namespace

void add_city(Pieces& pieces) {
  add_street(pieces);
  add_square(pieces);
  add_tower(pieces);
  const std::vector<Lot> left = {
      {-236.0f, -150.0f, 0.0f, 150.0f, kBrick},   {-150.0f, -104.0f, 3.0f, 210.0f, kConcrete},
      {-104.0f, -44.0f, 0.0f, 96.0f, kSandstone}, {-44.0f, 74.0f, 62.0f, 118.0f, kConcrete},
      {74.0f, 150.0f, 0.0f, 88.0f, kBrick},       {150.0f, 236.0f, 2.0f, 130.0f, kSlate},
      {236.0f, kEndZ, 0.0f, 104.0f, kSandstone}};
  const std::vector<Lot> right = {
      {-236.0f, -170.0f, 2.0f, 190.0f, kSlate},  {-170.0f, -110.0f, 0.0f, 120.0f, kSandstone},
      {-110.0f, -30.0f, 4.0f, 250.0f, kBrick},   {-30.0f, 24.0f, 0.0f, 140.0f, kConcrete},
      {24.0f, 98.0f, 2.0f, 230.0f, kSlate},      {98.0f, 170.0f, 0.0f, 112.0f, kSandstone},
      {170.0f, 250.0f, 3.0f, 180.0f, kConcrete}, {250.0f, kEndZ, 0.0f, 90.0f, kBrick}};
  for (const Lot& lot : left) add_building(pieces, lot, -1.0f);
  for (const Lot& lot : right) add_building(pieces, lot, 1.0f);
}

}  // namespace raywalk::robots
