// Cupboards with panelled doors and drawers, and the worktop.
#include "scenes/kitchen/parts.h"

namespace raywalk::kitchen {
namespace {

constexpr float kGap = 0.004f, kFront = 0.022f;

/// A panelled front whose lower left corner is the place's origin.
void add_front(Pieces& pieces, const Placement& place, float width, float height, u32 inside) {
  const float frame = smaller(0.075f, 0.28f * height), x1 = width - kGap, y1 = height - kGap;
  add_box(pieces, place, {kGap, kGap, 0.0f}, {kGap + frame, y1, kFront}, kCupboard, kFlat);
  add_box(pieces, place, {x1 - frame, kGap, 0.0f}, {x1, y1, kFront}, kCupboard, kFlat);
  add_box(pieces, place, {kGap + frame, kGap, 0.0f}, {x1 - frame, kGap + frame, kFront}, kCupboard, kFlat);
  add_box(pieces, place, {kGap + frame, y1 - frame, 0.0f}, {x1 - frame, y1, kFront}, kCupboard, kFlat);
  add_box(pieces, place, {kGap + frame, kGap + frame, 0.0f}, {x1 - frame, y1 - frame, 0.4f * kFront}, inside, kFlat);
}

void add_drawer(Pieces& pieces, const Placement& place, float width, float height) {
  add_front(pieces, place, width, height, kPanel);
  const float y = 0.5f * height;
  add_handle(pieces, place, {0.5f * width - 0.07f, y, kFront}, {0.5f * width + 0.07f, y, kFront}, 0.035f);
}

void add_door(Pieces& pieces, const Placement& place, float width, float height, bool handle_right, float handle_y,
              u32 inside) {
  add_front(pieces, place, width, height, inside);
  const float x = handle_right ? width - 0.045f : 0.045f;
  add_handle(pieces, place, {x, handle_y - 0.07f, kFront}, {x, handle_y + 0.07f, kFront}, 0.035f);
}

/// `open` is the height that its body leaves free at the top.
void add_base_unit(Pieces& pieces, const Placement& place, bool drawers, bool handle_right, float open = 0.0f) {
  const float bottom = 0.10f, top = kTop - kThick;
  add_box(pieces, place, {0.0f, 0.0f, 0.0f}, {kUnit, bottom, kDeep - 0.06f}, kPlinth, kFlat);
  add_box(pieces, place, {0.0f, bottom, 0.0f}, {kUnit, top - open, kDeep}, kCupboard, kFlat);
  const auto front_at = [&](float y) { return place.inner({0.0f, y, kDeep}); };
  if (drawers) {
    const float pitch = (top - bottom) / 4.0f;
    for (int i = 0; i < 4; ++i) add_drawer(pieces, front_at(bottom + pitch * static_cast<float>(i)), kUnit, pitch);
    return;
  }
  const float split = top - 0.17f;
  add_door(pieces, front_at(bottom), kUnit, split - bottom, handle_right, split - bottom - 0.12f, kPanel);
  add_drawer(pieces, front_at(split), kUnit, top - split);
}

void add_wall_unit(Pieces& pieces, const Placement& place, bool handle_right) {
  add_box(pieces, place, {0.0f, kHighFrom, 0.0f}, {kUnit, kHighTo, kHighDeep}, kCupboard, kFlat);
  add_door(pieces, place.inner({0.0f, kHighFrom, kHighDeep}), kUnit, kHighTo - kHighFrom, handle_right, 0.14f, kPanel);
  // A cornice that steps out.
  add_box(pieces, place, {0.0f, kHighTo, 0.0f}, {kUnit, kHighTo + 0.05f, kHighDeep + 0.05f}, kCupboard, kFlat);
  add_box(pieces, place, {0.0f, kHighTo + 0.05f, 0.0f}, {kUnit, kHighTo + 0.08f, kHighDeep + 0.09f}, kCupboard, kFlat);
}

/// A slab of the worktop with a rounded front edge.
void add_worktop(Pieces& pieces, const Placement& place, float x0, float x1, float z0, float z1) {
  add_box(pieces, place, {x0, kTop - kThick, z0}, {x1, kTop, z1}, kWorktop, kFlat);
  const float r = 0.5f * kThick;
  if (z1 == kOverhang)
    add_rod(pieces, place.point({x0, kTop - r, z1}), place.point({x1, kTop - r, z1}), r, kWorktop, 4.0);
}

}  // namespace

Placement on_far_wall(float x) {
  return Placement::at({x, 0.0f, -kEndZ});
}

Placement on_left_wall(float z) {
  return Placement::at({-kSideX, 0.0f, z}, 0.25);
}

void add_handle(Pieces& pieces, const Placement& place, Vec3 from, Vec3 to, float out) {
  const Vec3 off = {0.0f, 0.0f, out}, step = 0.12f * (to - from);
  const float r = 0.0055f;
  const auto at = [&](Vec3 p) { return TubePoint{place.point(p), r}; };
  add_tube(pieces,
           {at(from), at(from + 0.7f * off), at(from + off + step), at(to + off - step), at(to + 0.7f * off), at(to)},
           kChrome, 8.0 * kTiny);
}

void add_cupboards(Pieces& pieces) {
  // The far wall: eleven units between the corners, the sink in the middle one's place.
  const float start = -5.5f * kUnit;
  for (int i = 0; i < 11; ++i) {
    const Placement place = on_far_wall(start + kUnit * static_cast<float>(i));
    add_base_unit(pieces, place, i == 2 || i == 7, i % 2 == 0, i == 5 ? kSinkDeep : 0.0f);
    const float x = place.origin.x;
    if (x + kUnit < kSinkWindow.a - 0.1f || x > kSinkWindow.b + 0.1f) add_wall_unit(pieces, place, i % 2 == 0);
  }
  add_box(pieces, {}, {-kSideX, 0.0f, -kEndZ}, {start, kTop - kThick, -kEndZ + kDeep}, kCupboard, kFlat);
  add_box(pieces, {}, {-start, 0.0f, -kEndZ}, {kSideX, kTop - kThick, -kEndZ + kDeep}, kCupboard, kFlat);
  const Placement far_wall = on_far_wall(0.0f);
  add_worktop(pieces, far_wall, -kSideX, -kSinkX, 0.0f, kOverhang);
  add_worktop(pieces, far_wall, kSinkX, kSideX, 0.0f, kOverhang);
  add_worktop(pieces, far_wall, -kSinkX, kSinkX, 0.0f, 0.13f);
  add_worktop(pieces, far_wall, -kSinkX, kSinkX, 0.53f, kOverhang);

  // The left wall: eight places, the third is the oven's.
  for (int i = 0; i < 8; ++i) {
    const Placement place = on_left_wall(1.55f - kUnit * static_cast<float>(i));
    if (i != 2) add_base_unit(pieces, place, i == 1 || i == 5, i % 2 == 0);
    if (i != 2 && i < 7) add_wall_unit(pieces, place, i % 2 == 0);
  }
  const Placement left_wall = on_left_wall(1.55f);
  add_worktop(pieces, left_wall, 0.0f, 2.0f * kUnit, 0.0f, kOverhang);
  add_worktop(pieces, left_wall, 3.0f * kUnit, 1.55f + kEndZ - kOverhang, 0.0f, kOverhang);
}

}  // namespace raywalk::kitchen
