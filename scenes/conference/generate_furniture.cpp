// Around the walls: screen and whiteboard, the sideboard with coffee and a mirror, pictures, plants.
#include "scenes/conference/parts.h"

namespace raywalk::conference {
namespace {

/// A framed rectangle, its lower middle at the place, looking along local +z.
void add_framed(Pieces& pieces, const Placement& place, float width, float height, float f, u32 frame, u32 inside) {
  const float x = 0.5f * width;
  add_pad(pieces, place, {0.0f, -0.5f * f, 0.02f}, {x + f, 0.5f * f, 0.025f}, 0.4f * f, frame, 2);
  add_pad(pieces, place, {0.0f, height + 0.5f * f, 0.02f}, {x + f, 0.5f * f, 0.025f}, 0.4f * f, frame, 2);
  add_pad(pieces, place, {-x - 0.5f * f, 0.5f * height, 0.02f}, {0.5f * f, 0.5f * height, 0.025f}, 0.4f * f, frame, 2);
  add_pad(pieces, place, {x + 0.5f * f, 0.5f * height, 0.02f}, {0.5f * f, 0.5f * height, 0.025f}, 0.4f * f, frame, 2);
  add_plate(pieces, place.point({-x, 0.0f, 0.02f}), place.direction({width, 0.0f, 0.0f}), {0.0f, height, 0.0f}, inside);
}

/// The screen shows a chart: a title, bars, a curve.
void add_screen(Pieces& pieces) {
  const Placement place = Placement::at({-kHalfLength, 0.95f, 0.9f}, 0.25);
  add_framed(pieces, place, 3.0f, 1.6f, 0.03f, kPlastic, kScreen);
  add_lathe(pieces, Placement::at(place.point({0.0f, 1.70f, 0.06f})),
            {{0.001f, -0.05f}, {0.05f, -0.04f}, {0.05f, 0.04f}, {0.001f, 0.05f}}, 16, kTrim);
  add_block(pieces, place, {-1.6f, 1.65f, 0.0f}, {1.6f, 1.78f, 0.12f}, kTrim);
  const auto on_screen = [&](float x, float y, float width, float height, u32 material) {
    add_plate(pieces, place.point({x, y, 0.022f}), place.direction({width, 0.0f, 0.0f}), {0.0f, height, 0.0f},
              material);
  };
  on_screen(-1.3f, 1.36f, 1.5f, 0.09f, kBlue);
  on_screen(-1.3f, 0.18f, 2.6f, 0.012f, kPlastic);
  on_screen(-1.3f, 0.18f, 0.012f, 1.05f, kPlastic);
  const float bars[] = {0.30f, 0.42f, 0.38f, 0.55f, 0.63f, 0.60f, 0.78f, 0.92f};
  for (int i = 0; i < 8; ++i) {
    on_screen(-1.18f + 0.31f * static_cast<float>(i), 0.195f, 0.19f, bars[i], i == 7 ? kOrange : kBlue);
  }
  const std::vector<Vec3> curve = {
      {-1.15f, 0.42f, 0.03f}, {-0.4f, 0.60f, 0.03f}, {0.4f, 0.86f, 0.03f}, {1.15f, 1.24f, 0.03f}};
  add_tube(pieces, place, curve, 0.009f, {6, 40}, kOrange);
}

void add_whiteboard(Pieces& pieces) {
  const Placement place = Placement::at({-kHalfLength, 0.95f, -2.35f}, 0.25);
  add_framed(pieces, place, 2.0f, 1.25f, 0.03f, kChrome, kBoard);
  add_pad(pieces, place, {0.0f, -0.05f, 0.06f}, {0.8f, 0.012f, 0.05f}, 0.01f, kChrome, 2);
  const u32 inks[] = {kBlue, kOrange, kGreen, kPlastic};
  for (int i = 0; i < 4; ++i) {
    const float x = -0.5f + 0.22f * static_cast<float>(i);
    add_tube(pieces, place, {{x, -0.028f, 0.07f}, {x + 0.06f, -0.028f, 0.068f}, {x + 0.12f, -0.028f, 0.07f}}, 0.010f,
             {10, 2}, inks[i]);
  }
  // A sketch: three boxes and arrows.
  const auto stroke = [&](std::vector<Vec3> points, u32 ink) { add_tube(pieces, place, points, 0.006f, {5, 24}, ink); };
  for (int i = 0; i < 3; ++i) {
    const float x = -0.75f + 0.6f * static_cast<float>(i), y = 0.55f + 0.12f * static_cast<float>(i % 2);
    stroke({{x, y, 0.023f},
            {x + 0.17f, y - 0.02f, 0.023f},
            {x + 0.33f, y + 0.01f, 0.023f},
            {x + 0.34f, y + 0.14f, 0.023f},
            {x + 0.32f, y + 0.27f, 0.023f},
            {x + 0.15f, y + 0.26f, 0.023f},
            {x, y + 0.28f, 0.023f},
            {x - 0.01f, y + 0.12f, 0.023f},
            {x, y, 0.023f}},
           kBlue);
    if (i == 2) continue;
    stroke({{x + 0.36f, y + 0.14f, 0.023f}, {x + 0.46f, y + 0.18f, 0.023f}, {x + 0.57f, 0.75f, 0.023f}}, kOrange);
  }
  stroke({{-0.7f, 0.30f, 0.023f},
          {-0.35f, 0.22f, 0.023f},
          {0.0f, 0.34f, 0.023f},
          {0.4f, 0.20f, 0.023f},
          {0.8f, 0.30f, 0.023f}},
         kGreen);
}

void add_sideboard(Pieces& pieces) {
  const Placement place = Placement::at({kHalfLength - 0.05f, 0.0f, 0.0f}, -0.25);
  add_pad(pieces, place, {0.0f, 0.87f, 0.25f}, {1.45f, 0.02f, 0.26f}, 0.018f, kInlay, 3);
  add_block(pieces, place, {-1.40f, 0.08f, 0.01f}, {1.40f, 0.85f, 0.46f}, kTable);
  add_block(pieces, place, {-1.36f, 0.0f, 0.03f}, {1.36f, 0.08f, 0.42f}, kPlastic);
  for (int i = 0; i < 4; ++i) {
    const float x = -1.05f + 0.70f * static_cast<float>(i);
    add_pad(pieces, place, {x, 0.465f, 0.46f}, {0.33f, 0.36f, 0.016f}, 0.014f, kTable, 3);
    const float h = x + (i % 2 ? -0.26f : 0.26f);
    add_tube(pieces, place, {{h, 0.42f, 0.47f}, {h, 0.43f, 0.505f}, {h, 0.56f, 0.505f}, {h, 0.57f, 0.47f}}, 0.007f,
             {12, 18}, kBrass);
  }
  add_framed(pieces, place.inner({0.0f, 1.22f, 0.01f}), 2.0f, 1.15f, 0.06f, kBrass, kMirror);

  const Placement urn = place.inner({-0.85f, 0.89f, 0.24f});
  add_lathe(pieces, urn,
            {{0.11f, 0.0f},
             {0.115f, 0.02f},
             {0.09f, 0.04f},
             {0.12f, 0.08f},
             {0.135f, 0.16f},
             {0.13f, 0.30f},
             {0.10f, 0.37f},
             {0.06f, 0.40f},
             {0.02f, 0.41f},
             {0.03f, 0.44f},
             {0.001f, 0.465f}},
            40, kChrome);
  add_tube(pieces, urn, {{0.0f, 0.10f, 0.12f}, {0.0f, 0.10f, 0.18f}, {0.0f, 0.07f, 0.20f}}, 0.012f, {12, 12}, kChrome);
  for (int i = 0; i < 8; ++i) {
    const Placement cup =
        place.inner({-0.45f + 0.14f * static_cast<float>(i % 4), 0.89f, i < 4 ? 0.18f : 0.33f}, 0.07 * i);
    add_lathe(pieces, cup, {{0.001f, 0.004f}, {0.04f, 0.004f}, {0.065f, 0.012f}, {0.066f, 0.014f}, {0.04f, 0.008f}}, 24,
              kPorcelain);
    add_lathe(pieces, cup,
              {{0.02f, 0.008f},
               {0.024f, 0.012f},
               {0.036f, 0.04f},
               {0.040f, 0.07f},
               {0.037f, 0.07f},
               {0.033f, 0.04f},
               {0.001f, 0.016f}},
              24, kPorcelain);
    add_tube(pieces, cup,
             {{0.036f, 0.055f, 0.0f}, {0.058f, 0.05f, 0.0f}, {0.055f, 0.03f, 0.0f}, {0.034f, 0.028f, 0.0f}}, 0.004f,
             {8, 12}, kPorcelain);
  }
  add_lathe(pieces, place.inner({0.95f, 0.89f, 0.25f}),
            {{0.06f, 0.0f},
             {0.065f, 0.01f},
             {0.13f, 0.12f},
             {0.14f, 0.19f},
             {0.09f, 0.30f},
             {0.045f, 0.36f},
             {0.05f, 0.41f},
             {0.07f, 0.44f},
             {0.06f, 0.44f},
             {0.038f, 0.40f},
             {0.03f, 0.36f}},
            48, kBlue);
  add_sphere(pieces, place.point({0.55f, 0.98f, 0.26f}), 0.09f, kGlass, 1200.0 / 0.102);
}

void add_leaf(Pieces& pieces, Vec3 root, double turns, float reach, float rise) {
  const Placement place = Placement::at(root, turns);
  const auto leaf = [=](float u, float v) {
    const float side = 2.0f * u - 1.0f;
    const float half_width = 0.32f * reach * v * (1.0f - v) * (1.7f - 0.9f * v) + 0.003f;
    return place.point({reach * v * (0.3f + 0.7f * v), rise * v * (1.9f - 1.2f * v) + 0.3f * half_width * side * side,
                        -half_width * side});
  };
  add_sheet(pieces, leaf, {4, 12}, kLeaf);
}

void add_plant(Pieces& pieces, Vec3 at, u32 seed) {
  add_lathe(pieces, Placement::at(at),
            {{0.001f, 0.001f},
             {0.17f, 0.001f},
             {0.20f, 0.10f},
             {0.23f, 0.40f},
             {0.24f, 0.44f},
             {0.215f, 0.44f},
             {0.20f, 0.39f},
             {0.001f, 0.38f}},
            40, kPot);
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const float young = static_cast<float>(i) / 60.0f;
    const float reach = random.between(0.34f, 0.50f) * (1.0f - 0.5f * young);
    add_leaf(pieces, at + Vec3{0.0f, 0.38f, 0.0f}, 0.381966 * i + random.between(-0.03f, 0.03f), reach,
             0.3f + 0.95f * young + random.between(0.0f, 0.15f));
  }
}

void add_pictures(Pieces& pieces) {
  const u32 colours[3][3] = {{kBlue, kOrange, kPaper}, {kGreen, kBlue, kOrange}, {kOrange, kGreen, kBlue}};
  for (int i = 0; i < 3; ++i) {
    const Placement place = Placement::at({0.9f - 2.6f * static_cast<float>(i), 1.30f, kHalfDepth - 0.04f}, 0.5);
    add_framed(pieces, place, 1.15f, 0.85f, 0.04f, kBrass, kPaper);
    for (int k = 0; k < 3; ++k) {
      const float x = -0.36f + 0.30f * static_cast<float>(k), y = 0.16f + 0.11f * static_cast<float>((i + k) % 3);
      const auto stone = [=](float u, float v) {
        const float radius = (1.0f - v) * (0.15f + 0.02f * static_cast<float>(sine_turns(2.0 * u + 0.3 * i)));
        return place.point({x + 0.06f + radius * static_cast<float>(cosine_turns(u)),
                            y + 0.16f + 1.25f * radius * static_cast<float>(sine_turns(u)),
                            0.022f + 0.001f * static_cast<float>(k)});
      };
      add_sheet(pieces, stone, {40, 1}, colours[i][k]);
    }
  }
}

}  // namespace

void add_furniture(Pieces& pieces) {
  add_screen(pieces);
  add_whiteboard(pieces);
  add_sideboard(pieces);
  add_pictures(pieces);
  add_plant(pieces, {5.72f, 0.0f, -3.35f}, 31);
  add_plant(pieces, {-5.72f, 0.0f, 3.42f}, 32);
}

}  // namespace raywalk::conference
