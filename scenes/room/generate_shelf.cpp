// The bookshelf and its books.
#include "scenes/room/parts.h"

namespace raywalk::room {
namespace {

constexpr float kWidth = 1.9f, kDepth = 0.30f, kTall = 2.1f, kBoard = 0.025f;
constexpr int kShelves = 5;

/// Upright books from the left, a gap now and then, the last of a group leaning on nothing.
void add_books(Pieces& pieces, const Placement& place, float bottom, float room_above, Random& random) {
  const u32 colours[] = {kBookRed, kBookBlue, kBookGreen, kBookCream, kWood, kCeramic, kOrange};
  float x = -0.5f * kWidth + 0.04f;
  while (x < 0.5f * kWidth - 0.10f) {
    if (random.unit() < 0.06f) {
      x += random.between(0.10f, 0.25f);
      continue;
    }
    const float thick = random.between(0.018f, 0.05f), tall = room_above * random.between(0.62f, 0.93f);
    const float deep = random.between(0.16f, 0.24f);
    add_box(pieces, place, {x, bottom, 0.03f}, {x + thick, bottom + tall, 0.03f + deep}, colours[random.below(7)],
            kFlat);
    x += thick + 0.0015f;
  }
}

}  // namespace

void add_shelf(Pieces& pieces) {
  // Stands on the right wall and looks to the left: local z is out of the wall.
  const Placement place = Placement::at({kRightX, 0.0f, 0.0f}, -0.25);
  const float x = 0.5f * kWidth;
  add_box(pieces, place, {-x, 0.0f, 0.0f}, {-x + kBoard, kTall, kDepth}, kWood, kFlat);
  add_box(pieces, place, {x - kBoard, 0.0f, 0.0f}, {x, kTall, kDepth}, kWood, kFlat);
  add_box(pieces, place, {-x + kBoard, 0.0f, 0.0f}, {x - kBoard, kTall, 0.01f}, kWood, kFlat);
  Random random(42);
  const float pitch = (kTall - kBoard) / kShelves;
  for (int i = 0; i <= kShelves; ++i) {
    const float y = pitch * static_cast<float>(i);
    add_box(pieces, place, {-x + kBoard, y, 0.01f}, {x - kBoard, y + kBoard, kDepth}, kWood, kFlat);
    if (i < kShelves) add_books(pieces, place, y + kBoard, pitch - kBoard, random);
  }
  const Vec3 top = place.point({-0.5f, kTall + kBoard + 0.11f, 0.16f});
  add_sphere(pieces, top, 0.11f, kChrome, kFine);
}

}  // namespace raywalk::room
