// The wall of windows: frames, panes, sills, curtains on their rods.
#include "scenes/conference/parts.h"

namespace raywalk::conference {
namespace {

constexpr int kWindows = 4;
constexpr float kPitch = 2.9f, kHalfWindow = 0.95f, kSill = 0.75f, kLintel = 2.55f;

float middle_of(int window) {
  return kPitch * (static_cast<float>(window) - 0.5f * (kWindows - 1));
}

void add_wall(Pieces& pieces) {
  const auto part = [&](float x0, float y0, float x1, float y1) {
    add_plate(pieces, {x0, y0, -kHalfDepth}, {x1 - x0, 0.0f, 0.0f}, {0.0f, y1 - y0, 0.0f}, kWall);
  };
  part(-kHalfLength, 0.0f, kHalfLength, kSill);
  part(-kHalfLength, kLintel, kHalfLength, kHeight);
  for (int i = 0; i <= kWindows; ++i) {
    const float from = i == 0 ? -kHalfLength : middle_of(i - 1) + kHalfWindow;
    part(from, kSill, i == kWindows ? kHalfLength : middle_of(i) - kHalfWindow, kLintel);
  }
}

void add_frame(Pieces& pieces, const Placement& place) {
  const auto bar = [&](float x0, float y0, float x1, float y1, float deep) {
    add_block(pieces, place, {x0, y0, 0.0f}, {x1, y1, deep}, kTrim);
  };
  const float w = kHalfWindow, f = 0.06f;
  bar(-w - f, kSill - f, -w, kLintel + f, 0.07f);
  bar(w, kSill - f, w + f, kLintel + f, 0.07f);
  bar(-w, kLintel, w, kLintel + f, 0.07f);
  bar(-w, kSill - f, w, kSill, 0.07f);
  bar(-0.03f, kSill, 0.03f, kLintel, 0.05f);
  bar(-w, 1.98f, w, 2.03f, 0.05f);
  add_plate(pieces, place.point({-w, kSill, 0.02f}), {2.0f * w, 0.0f, 0.0f}, {0.0f, kLintel - kSill, 0.0f}, kPane);
  add_pad(pieces, place, {0.0f, kSill - 0.08f, 0.10f}, {w + 0.12f, 0.025f, 0.10f}, 0.022f, kTrim, 3);
  // A convector of fins below.
  for (int i = 0; i < 30; ++i) {
    const float x = -0.87f + 0.06f * static_cast<float>(i);
    add_block(pieces, place, {x - 0.012f, 0.16f, 0.02f}, {x + 0.012f, 0.55f, 0.12f}, kVent);
  }
  add_block(pieces, place, {-0.93f, 0.12f, 0.0f}, {0.93f, 0.16f, 0.13f}, kTrim);
  add_block(pieces, place, {-0.93f, 0.55f, 0.0f}, {0.93f, 0.58f, 0.13f}, kTrim);
}

void add_curtains(Pieces& pieces, const Placement& place, u32 seed) {
  const float rod = 2.74f, off = 0.16f;
  add_tube(pieces, place, {{-1.42f, rod, off}, {0.0f, rod, off}, {1.42f, rod, off}}, 0.016f, {12, 2}, kBrass);
  Random random(seed);
  for (const float side : {-1.0f, 1.0f}) {
    add_sphere(pieces, place.point({1.44f * side, rod, off}), 0.03f, kBrass, 100.0 / 0.0113);
    const float shift = random.unit(), inner = random.between(0.72f, 0.84f);
    const auto drape = [=](float u, float v) {
      // Pleats are even at the rod and wander below.
      const double wander = 0.16 * (1.0 - static_cast<double>(v)) * sine_turns(1.7 * u + shift);
      const float fold = static_cast<float>(sine_turns(9.0 * u + wander));
      const float x = inner + (1.38f - inner) * (u + 0.015f * (1.0f - v) * fold);
      return place.point({side * x, 0.03f + (rod - 0.035f) * v, off + (0.050f - 0.012f * v) * fold});
    };
    add_sheet(
        pieces, [=](float u, float v) { return drape(side > 0.0f ? u : 1.0f - u, v); }, {108, 14}, kCurtain);
    for (int i = 0; i < 9; ++i) {
      const float x = side * (inner + (1.38f - inner) * (static_cast<float>(i) + 0.25f) / 9.0f);
      const auto ring = [=](float u, float v) {
        const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
        const float radius = 0.022f + 0.004f * c;
        return place.point({x + 0.004f * s, rod + radius * static_cast<float>(sine_turns(v)),
                            off + radius * static_cast<float>(cosine_turns(v))});
      };
      add_sheet(pieces, ring, {5, 10}, kBrass);
    }
  }
}

}  // namespace

void add_windows(Pieces& pieces) {
  add_wall(pieces);
  for (int i = 0; i < kWindows; ++i) {
    const Placement place = Placement::at({middle_of(i), 0.0f, -kHalfDepth});
    add_frame(pieces, place);
    add_curtains(pieces, place, static_cast<u32>(i));
  }
}

}  // namespace raywalk::conference
