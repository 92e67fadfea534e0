// The ceiling: acoustic tiles, vents, downlights, two pendants and the projector.
#include "scenes/conference/parts.h"

namespace raywalk::conference {
namespace {

constexpr float kTile = 0.014f;  // from the ceiling to the face of its tiles

void add_tiles(Pieces& pieces) {
  add_plate(pieces, {-kHalfLength, kHeight, -kHalfDepth}, {2.0f * kHalfLength, 0.0f, 0.0f},
            {0.0f, 0.0f, 2.0f * kHalfDepth}, kVent);
  constexpr int kColumns = 20, kRows = 13;
  const float width = 2.0f * kHalfLength / kColumns, depth = 2.0f * kHalfDepth / kRows, gap = 0.005f;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const float x = -kHalfLength + width * static_cast<float>(i % kColumns);
    const float z = -kHalfDepth + depth * static_cast<float>(i / kColumns);
    add_plate(pieces, {x + gap, kHeight - kTile, z + gap}, {width - 2.0f * gap, 0.0f, 0.0f},
              {0.0f, 0.0f, depth - 2.0f * gap}, kCeiling);
  }
}

void add_vent(Pieces& pieces, Vec3 at) {
  const Placement place = Placement::at(at);
  const float w = 0.30f, f = 0.03f;
  add_block(pieces, place, {-w, -0.02f, -w}, {w, 0.0f, -w + f}, kVent);
  add_block(pieces, place, {-w, -0.02f, w - f}, {w, 0.0f, w}, kVent);
  add_block(pieces, place, {-w, -0.02f, -w + f}, {-w + f, 0.0f, w - f}, kVent);
  add_block(pieces, place, {w - f, -0.02f, -w + f}, {w, 0.0f, w - f}, kVent);
  for (int i = 0; i < 12; ++i) {
    const float z = -0.25f + 0.045f * static_cast<float>(i);
    const auto slat = [=](float u, float v) {
      const float bend = static_cast<float>(sine_turns(0.25 * v));
      return place.point({-w + f + u * 2.0f * (w - f), -0.03f + 0.028f * v, z + 0.022f * bend});
    };
    add_sheet(pieces, slat, {1, 6}, kVent);
  }
}

void add_downlight(Pieces& pieces, Vec3 at) {
  add_lathe(pieces, Placement::at(at),
            {{0.055f, -0.004f}, {0.060f, -0.012f}, {0.085f, -0.016f}, {0.095f, -0.010f}, {0.098f, 0.0f}}, 32, kChrome);
  add_lathe(pieces, Placement::at(at), {{0.001f, -0.002f}, {0.03f, -0.003f}, {0.056f, -0.004f}}, 32, kDiffuser);
}

/// A ring that hangs over the light.
void add_pendant(Pieces& pieces, Vec3 at) {
  const Placement place = Placement::at(at);
  const float r = 0.72f;
  add_lathe(pieces, place,
            {{r - 0.02f, -0.035f},
             {r + 0.015f, -0.035f},
             {r + 0.025f, -0.025f},
             {r + 0.025f, 0.025f},
             {r + 0.015f, 0.035f},
             {r - 0.02f, 0.035f}},
            96, kChrome);
  add_lathe(pieces, place, {{r - 0.02f, 0.035f}, {r - 0.03f, 0.0f}, {r - 0.02f, -0.035f}}, 96, kDiffuser);
  const float up = kHeight - at.y;
  for (int i = 0; i < 3; ++i) {
    const double turns = i / 3.0 + 0.08;
    const Vec3 foot = {r * static_cast<float>(cosine_turns(turns)), 0.03f, r * static_cast<float>(sine_turns(turns))};
    const Vec3 hook = {0.08f * foot.x, up - 0.03f, 0.08f * foot.z};
    add_tube(pieces, place, {foot, 0.5f * (foot + hook), hook}, 0.003f, {6, 2}, kChrome);
  }
  add_lathe(pieces, place, {{0.001f, up - 0.06f}, {0.08f, up - 0.055f}, {0.10f, up - 0.03f}, {0.10f, up - kTile}}, 32,
            kChrome);
}

void add_projector(Pieces& pieces, Vec3 at) {
  const Placement place = Placement::at(at, -0.25);
  add_pad(pieces, place, {0.0f, 0.0f, 0.0f}, {0.19f, 0.055f, 0.15f}, 0.025f, kTrim, 4);
  const Placement lens = place.inner({0.07f, 0.0f, 0.0f});
  const auto barrel = [=](float u, float v) {
    const float radius = v < 0.75f ? 0.045f - 0.005f * v : 0.16f * (1.0f - v) + 0.002f;
    return lens.point({radius * static_cast<float>(cosine_turns(u)), radius * static_cast<float>(sine_turns(u)),
                       0.15f + (v < 0.75f ? 0.06f * v : 0.035f)});
  };
  add_sheet(pieces, barrel, {32, 8}, kPlastic);
  for (int i = 0; i < 8; ++i) {
    const float x = -0.15f + 0.018f * static_cast<float>(i);
    add_block(pieces, place, {x, -0.025f, 0.149f}, {x + 0.008f, 0.025f, 0.153f}, kPlastic);
  }
  add_lathe(pieces, place,
            {{0.022f, 0.05f},
             {0.022f, kHeight - at.y - 0.05f},
             {0.07f, kHeight - at.y - 0.03f},
             {0.07f, kHeight - at.y - 0.012f}},
            24, kChrome);
}

}  // namespace

void add_ceiling(Pieces& pieces) {
  add_tiles(pieces);
  const float under = kHeight - kTile;
  for (const float z : {-2.75f, 2.75f}) {
    for (const float x : {-4.37f, -1.25f, 1.87f, 4.99f}) add_vent(pieces, {x, under, z});
    for (int i = 0; i < 6; ++i) add_downlight(pieces, {-5.3f + 2.12f * static_cast<float>(i), under, 1.15f * z});
  }
  for (const float x : {-2.3f, 2.3f}) add_pendant(pieces, {x, 2.44f, 0.0f});
  add_projector(pieces, {0.0f, 2.62f, 0.0f});
}

}  // namespace raywalk::conference
