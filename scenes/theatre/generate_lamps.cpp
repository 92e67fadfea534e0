// The chandelier, lamps on the walls and the bar of stage lamps.
#include "scenes/theatre/parts.h"

namespace raywalk::theatre {
namespace {

/// Rings of candles and crystals; the light is below its open middle.
void add_chandelier(Pieces& pieces) {
  const Placement place = Placement::at({0.0f, 5.6f, 0.8f});
  const auto ring = [&](float radius, float height, float thick, u32 chords) {
    const std::vector<ProfilePoint> profile = {{radius, height - thick},
                                               {radius + thick, height},
                                               {radius, height + thick},
                                               {radius - thick, height},
                                               {radius, height - thick}};
    add_lathe(pieces, place, profile, chords, kBrass);
  };
  const auto around = [&](int i, int n, float radius, float height) {
    const double turns = static_cast<double>(i) / n;
    return Vec3{radius * static_cast<float>(cosine_turns(turns)), height,
                radius * static_cast<float>(sine_turns(turns))};
  };
  ring(1.25f, 0.0f, 0.035f, 36);
  ring(0.80f, 0.55f, 0.03f, 28);
  ring(0.35f, 0.95f, 0.025f, 16);
  const std::vector<ProfilePoint> candle = {{0.045f, 0.0f}, {0.05f, 0.03f}, {0.018f, 0.035f}, {0.018f, 0.14f}};
  const std::vector<ProfilePoint> flame = {{0.006f, 0.14f}, {0.018f, 0.175f}, {0.001f, 0.23f}};
  const std::vector<ProfilePoint> drop = {{0.002f, -0.24f}, {0.034f, -0.18f}, {0.022f, -0.12f}, {0.003f, -0.05f}};
  const auto candles = [&](int n, float radius, float height) {
    for (int i = 0; i < n; ++i) {
      const Placement at = place.inner(around(i, n, radius, height + 0.03f));
      add_lathe(pieces, at, candle, 5, kBrass);
      add_lathe(pieces, at, flame, 5, kFlame);
      add_lathe(pieces, place.inner(around(2 * i + 1, 2 * n, radius, height)), drop, 5, kCrystal);
    }
  };
  candles(14, 1.25f, 0.0f);
  candles(10, 0.80f, 0.55f);
  for (int i = 0; i < 6; ++i) {
    add_tube(pieces, place,
             {around(i, 6, 1.25f, 0.0f), around(i, 6, 1.10f, 0.35f), around(i, 6, 0.80f, 0.55f),
              around(i, 6, 0.62f, 0.75f), around(i, 6, 0.35f, 0.95f), around(i, 6, 0.12f, 1.4f)},
             0.014f, {5, 10}, kBrass);
  }
  add_lathe(pieces, place, {{0.012f, 1.35f}, {0.012f, kHeight - 5.6f}}, 6, kBrass);
  add_lathe(pieces, place, {{0.02f, 1.28f}, {0.13f, 1.33f}, {0.15f, 1.42f}, {0.06f, 1.52f}, {0.012f, 1.55f}}, 12,
            kBrass);
}

void add_wall_lamps(Pieces& pieces) {
  const std::vector<ProfilePoint> shade = {{0.05f, 0.0f}, {0.10f, 0.04f}, {0.13f, 0.16f}, {0.14f, 0.24f}};
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i < 4; ++i) {
      const float z = -4.9f + 3.05f * static_cast<float>(i), y = i < 2 ? 2.9f : i < 3 ? 3.0f : 5.9f;
      const Placement place = Placement::at({side * (kHalfWidth - 0.14f), y, z}, side < 0.0f ? 0.25 : -0.25);
      add_pad(pieces, place, {0.0f, 0.0f, 0.02f}, {0.07f, 0.16f, 0.03f}, 0.02f, kBrass);
      add_tube(pieces, place, {{0.0f, -0.05f, 0.04f}, {0.0f, -0.10f, 0.15f}, {0.0f, 0.02f, 0.20f}}, 0.015f, {6, 5},
               kBrass);
      add_lathe(pieces, place.inner({0.0f, 0.02f, 0.20f}), shade, 10, kFlame);
    }
  }
}

void add_stage_lamps(Pieces& pieces) {
  const Placement bar = Placement::at({0.0f, 7.05f, -3.3f});
  add_tube(pieces, bar, {{-4.6f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {4.6f, 0.0f, 0.0f}}, 0.035f, {8, 2}, kLampMetal);
  for (const float x : {-4.0f, -1.35f, 1.35f, 4.0f}) {
    add_tube(pieces, bar, {{x, 0.0f, 0.0f}, {x, 0.5f, 0.0f}, {x, kHeight - 7.05f, 0.0f}}, 0.015f, {6, 2}, kLampMetal);
  }
  for (int i = 0; i < 8; ++i) {
    const float x = -4.1f + 8.2f / 7.0f * static_cast<float>(i);
    add_block(pieces, bar, {x - 0.15f, -0.30f, -0.02f}, {x - 0.13f, -0.02f, 0.02f}, kLampMetal);
    add_block(pieces, bar, {x + 0.13f, -0.30f, -0.02f}, {x + 0.15f, -0.02f, 0.02f}, kLampMetal);
    // The can looks down to the middle of the stage.
    const Vec3 at = bar.point({x, -0.28f, 0.0f});
    const Vec3 axis = normalized(Vec3{0.25f * x, kStage, -8.0f} - at);
    const Vec3 across = normalized(cross(axis, {0.0f, 1.0f, 0.0f})), other = cross(axis, across);
    const auto can = [=](float u, float v) {
      const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
      const float radius = v < 0.2f ? 0.3f * v + 0.02f : 0.10f + 0.06f * v;
      return at + (0.42f * v - 0.17f) * axis + radius * (c * across + s * other);
    };
    add_sheet(pieces, can, {10, 5}, kLampMetal);
    const auto lens = [=](float u, float v) {
      const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
      return at + (0.235f + 0.02f * v) * axis + (0.15f * (1.0f - v) + 0.002f) * (c * across + s * other);
    };
    add_sheet(pieces, lens, {10, 1}, kLens);
  }
}

}  // namespace

void add_lamps(Pieces& pieces) {
  add_chandelier(pieces);
  add_wall_lamps(pieces);
  add_stage_lamps(pieces);
}

}  // namespace raywalk::theatre
