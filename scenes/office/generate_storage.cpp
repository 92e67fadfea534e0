// The bookshelf on the right wall and filing cabinets beside it.
#include "scenes/office/parts.h"

namespace raywalk::office {
namespace {

constexpr float kHalfShelf = 0.9f, kDepth = 0.30f, kTall = 2.05f, kBoard = 0.022f;
constexpr int kShelves = 6;

void add_books(Pieces& pieces, const Placement& place, float from, float to, float bottom, Random& random) {
  const u32 colours[] = {kBookRed, kBookBlue, kBookGreen, kBookCream, kWood, kPlastic, kSea};
  float x = from;
  for (;;) {
    const float thick = random.between(0.022f, 0.055f), tall = random.between(0.20f, 0.285f);
    if (x + thick > to) return;
    const u32 colour = colours[random.below(7)];
    const float deep = random.between(0.17f, 0.23f);
    add_block(pieces, place, {x, bottom, 0.03f}, {x + thick, bottom + tall, 0.03f + deep}, colour);
    // A band across the back.
    const float at = bottom + tall * random.between(0.6f, 0.8f);
    add_plate(pieces, place.point({x, at, 0.0305f + deep}), place.direction({thick, 0.0f, 0.0f}), {0.0f, 0.02f, 0.0f},
              colour == kBookCream ? kWood : kBookCream);
    x += thick + 0.001f;
  }
}

void add_globe(Pieces& pieces, const Placement& place) {
  add_lathe(pieces, place, {{0.075f, 0.0f}, {0.075f, 0.012f}, {0.02f, 0.022f}, {0.01f, 0.05f}}, 20, kWood);
  add_sphere(pieces, place.point({0.0f, 0.15f, 0.0f}), 0.088f, kSea, 8'000.0);
  const auto meridian = [=](float u, float v) {
    const double turns = 0.55 * static_cast<double>(v) - 0.275;
    const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
    const Vec3 out = {static_cast<float>(cosine_turns(turns)), static_cast<float>(sine_turns(turns)), 0.0f};
    return place.point(Vec3{0.0f, 0.15f, 0.0f} + (0.10f + 0.005f * c) * out + Vec3{0.0f, 0.0f, 0.005f * s});
  };
  add_sheet(pieces, meridian, {6, 20}, kBrass);
}

void add_shelf(Pieces& pieces, const Placement& place) {
  const float x = kHalfShelf;
  add_block(pieces, place, {-x, 0.0f, 0.0f}, {-x + kBoard, kTall, kDepth}, kWood);
  add_block(pieces, place, {x - kBoard, 0.0f, 0.0f}, {x, kTall, kDepth}, kWood);
  add_block(pieces, place, {-kBoard, 0.0f, 0.01f}, {kBoard, kTall, kDepth - 0.005f}, kWood);
  add_block(pieces, place, {-x + kBoard, 0.0f, 0.0f}, {x - kBoard, kTall, 0.01f}, kWood);
  Random random(5);
  const float pitch = (kTall - kBoard) / kShelves;
  for (int i = 0; i <= kShelves; ++i) {
    const float y = pitch * static_cast<float>(i);
    add_block(pieces, place, {-x + kBoard, y, 0.01f}, {x - kBoard, y + kBoard, kDepth - 0.002f}, kWood);
    if (i == kShelves) break;
    const float bottom = y + kBoard, left = -x + kBoard + 0.005f, right = x - kBoard - 0.005f;
    add_books(pieces, place, left, i == 3 ? -0.45f : -kBoard - 0.005f, bottom, random);
    add_books(pieces, place, i == 2 ? 0.45f : kBoard + 0.005f, i == 4 ? 0.5f : right, bottom, random);
    if (i == 3) add_globe(pieces, place.inner({-0.22f, bottom, 0.16f}));
    if (i == 2) {
      add_lathe(pieces, place.inner({0.22f, bottom, 0.16f}),
                {{0.06f, 0.0f},
                 {0.06f, 0.02f},
                 {0.015f, 0.04f},
                 {0.012f, 0.11f},
                 {0.05f, 0.15f},
                 {0.065f, 0.23f},
                 {0.06f, 0.23f},
                 {0.002f, 0.15f}},
                24, kBrass);
    }
    if (i == 4) add_sphere(pieces, place.point({0.68f, bottom + 0.08f, 0.16f}), 0.08f, kChrome, 8'000.0);
  }
}

void add_cabinet(Pieces& pieces, const Placement& place) {
  add_block(pieces, place, {-0.23f, 0.0f, 0.0f}, {0.23f, 1.32f, 0.60f}, kSteel);
  for (int i = 0; i < 4; ++i) {
    const float y = 0.17f + 0.32f * static_cast<float>(i);
    add_pad(pieces, place, {0.0f, y, 0.60f}, {0.215f, 0.15f, 0.014f}, 0.010f, kSteel, 2);
    add_tube(pieces, place,
             {{-0.06f, y + 0.02f, 0.61f},
              {-0.06f, y + 0.02f, 0.645f},
              {0.06f, y + 0.02f, 0.645f},
              {0.06f, y + 0.02f, 0.61f}},
             0.006f, {6, 9}, kChrome);
    add_block(pieces, place, {-0.05f, y + 0.07f, 0.61f}, {0.05f, y + 0.11f, 0.618f}, kPaper);
  }
}

}  // namespace

void add_storage(Pieces& pieces) {
  add_shelf(pieces, Placement::at({kHalf, 0.0f, -0.65f}, -0.25));
  add_cabinet(pieces, Placement::at({kHalf, 0.0f, 0.55f}, -0.25));
  add_cabinet(pieces, Placement::at({kHalf, 0.0f, 1.03f}, -0.25));
}

}  // namespace raywalk::office
