// What stands on the desk: monitor, keyboard and mouse, lamp, telephone, mug, pens, papers, glasses.
#include "scenes/office/parts.h"

namespace raywalk::office {
namespace {

/// Faces local +z; stands on y = 0. Two windows, a title bar and lines of text are on its screen.
void add_monitor(Pieces& pieces, const Placement& place) {
  add_pad(pieces, place, {0.0f, 0.34f, 0.0f}, {0.33f, 0.21f, 0.024f}, 0.012f, kPlastic, 2);
  const auto on_screen = [&](float x, float y, float width, float height, float off, u32 material) {
    add_plate(pieces, place.point({x, y, 0.0245f + off}), place.direction({width, 0.0f, 0.0f}), {0.0f, height, 0.0f},
              material);
  };
  on_screen(-0.31f, 0.15f, 0.62f, 0.38f, 0.0f, kScreenBlue);
  on_screen(-0.28f, 0.19f, 0.33f, 0.30f, 0.0005f, kScreen);
  on_screen(-0.28f, 0.47f, 0.33f, 0.02f, 0.001f, kSea);
  on_screen(0.09f, 0.25f, 0.19f, 0.22f, 0.0005f, kScreen);
  on_screen(0.09f, 0.45f, 0.19f, 0.02f, 0.001f, kBookRed);
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    on_screen(-0.26f, 0.445f - 0.021f * static_cast<float>(i), random.between(0.12f, 0.28f), 0.008f, 0.001f, kPlastic);
  }
  for (int i = 0; i < 5; ++i) {
    const float bar = random.between(0.04f, 0.15f);
    on_screen(0.105f + 0.034f * static_cast<float>(i), 0.265f, 0.022f, bar, 0.001f, i % 2 ? kBookGreen : kSea);
  }
  add_pad(pieces, place, {0.0f, 0.11f, -0.04f}, {0.035f, 0.11f, 0.014f}, 0.01f, kPlastic);
  add_slab(
      pieces, place,
      [](float t) {
        return Vec3{0.0f, 0.0f, -0.02f} + Vec3{0.14f, 0.0f, 0.10f} * on_circle(t);
      },
      {0.0f, 0.0f, -0.02f}, 0.0f, 0.012f, 28, kPlastic);
}

void add_keyboard(Pieces& pieces, const Placement& place) {
  add_pad(pieces, place, {0.0f, 0.009f, 0.0f}, {0.225f, 0.009f, 0.075f}, 0.006f, kPlastic);
  for (int row = 0; row < 5; ++row) {
    const int keys = row == 0 ? 9 : 15;
    for (int i = 0; i < keys; ++i) {
      const bool space = row == 0 && i == 4;
      const float step = 0.43f / static_cast<float>(keys), half = 0.5f * step - 0.002f;
      const float x = -0.215f + step * (static_cast<float>(i) + 0.5f), z = 0.052f - 0.026f * static_cast<float>(row);
      add_block(pieces, place, {x - half, 0.018f, z - 0.011f}, {x + half, 0.023f, z + 0.011f}, space ? kSteel : kPaper);
    }
  }
  const Placement mouse = place.inner({0.33f, 0.016f, 0.01f}, 0.03);
  add_cushion(pieces, mouse, {}, {0.031f, 0.016f, 0.053f}, kPlastic, 20'000.0);
  add_slab(
      pieces, mouse,
      [](float t) {
        return Vec3{0.12f, 0.0f, 0.10f} * on_circle(t);
      },
      {}, -0.016f, -0.013f, 24, kBookBlue);
}

/// A jointed arm with a bell over the papers.
void add_lamp(Pieces& pieces, const Placement& place) {
  add_lathe(pieces, place, {{0.10f, 0.0f}, {0.10f, 0.015f}, {0.08f, 0.028f}, {0.015f, 0.034f}, {0.014f, 0.06f}}, 24,
            kChrome);
  const Vec3 elbow = {-0.14f, 0.36f, 0.0f}, head = {0.16f, 0.52f, 0.0f};
  for (const float z : {-0.018f, 0.018f}) {
    const Vec3 off = {0.0f, 0.0f, z}, foot = {0.0f, 0.05f, 0.0f};
    add_tube(pieces, place, {foot + off, 0.5f * (foot + elbow) + off, elbow + off}, 0.006f, {8, 2}, kChrome);
    add_tube(pieces, place, {elbow + off, 0.5f * (elbow + head) + off, head + off}, 0.006f, {8, 2}, kChrome);
  }
  for (const Vec3 joint : {elbow, head}) add_sphere(pieces, place.point(joint), 0.022f, kPlastic, 30'000.0);
  const Placement bell = place.inner(head + Vec3{0.02f, 0.0f, 0.0f});
  add_lathe(pieces, bell,
            {{0.105f, -0.13f},
             {0.10f, -0.11f},
             {0.08f, -0.07f},
             {0.05f, -0.035f},
             {0.035f, 0.0f},
             {0.03f, 0.03f},
             {0.002f, 0.035f}},
            28, kBookGreen);
}

void add_telephone(Pieces& pieces, const Placement& place) {
  const auto body = [=](float u, float v) {
    const float x = 0.09f - 0.18f * u;
    return place.point({x, 0.03f + 0.045f * v, 0.10f - 0.20f * v});
  };
  add_sheet(
      pieces, [=](float u, float v) { return body(1.0f - u, v); }, {2, 2}, kPlastic);
  add_pad(pieces, place, {0.0f, 0.018f, 0.0f}, {0.095f, 0.018f, 0.105f}, 0.012f, kPlastic, 2);
  for (int i = 0; i < 12; ++i) {
    const float x = 0.005f + 0.028f * static_cast<float>(i % 3), z = 0.07f - 0.032f * static_cast<float>(i / 3);
    const float y = 0.052f - 0.225f * z;
    add_block(pieces, place, {x - 0.010f, y - 0.01f, z - 0.010f}, {x + 0.010f, y + 0.006f, z + 0.010f}, kPaper);
  }
  add_tube(pieces, place,
           {{-0.055f, 0.085f, 0.105f}, {-0.055f, 0.112f, 0.05f}, {-0.055f, 0.118f, -0.03f}, {-0.055f, 0.110f, -0.10f}},
           0.016f, {10, 12}, kPlastic);
  for (const float z : {0.088f, -0.085f}) {
    add_cushion(pieces, place, {-0.055f, 0.085f, z}, {0.028f, 0.020f, 0.030f}, kPlastic, 30'000.0);
  }
  // The coiled cord.
  const std::vector<Vec3> path = {{-0.055f, 0.075f, 0.11f},
                                  {-0.10f, 0.02f, 0.16f},
                                  {-0.16f, 0.015f, 0.14f},
                                  {-0.17f, 0.015f, 0.02f},
                                  {-0.10f, 0.02f, -0.02f}};
  const auto cord = [=](float u, float v) {
    const double winding = 18.0 * static_cast<double>(v);
    const Vec3 coil = {0.009f * static_cast<float>(cosine_turns(winding)),
                       0.009f * static_cast<float>(sine_turns(winding)) + 0.009f, 0.0f};
    const Vec3 thick = {0.003f * static_cast<float>(cosine_turns(u)), 0.003f * static_cast<float>(sine_turns(u)), 0.0f};
    return place.point(curve_at(path, v) + coil + thick);
  };
  add_sheet(pieces, cord, {4, 108}, kPlastic);
}

void add_vessels(Pieces& pieces, Vec3 top) {
  const Placement mug = Placement::at(top + Vec3{-1.56f, 0.0f, -0.98f}, 0.6);
  add_lathe(pieces, mug,
            {{0.002f, 0.001f},
             {0.036f, 0.001f},
             {0.040f, 0.006f},
             {0.041f, 0.09f},
             {0.039f, 0.093f},
             {0.037f, 0.09f},
             {0.036f, 0.012f},
             {0.002f, 0.010f}},
            24, kCeramic);
  add_tube(pieces, mug, {{0.038f, 0.075f, 0.0f}, {0.066f, 0.07f, 0.0f}, {0.066f, 0.03f, 0.0f}, {0.038f, 0.022f, 0.0f}},
           0.006f, {8, 12}, kCeramic);
  // Solid glass: light passes two surfaces, as many as the study's depth of two follows.
  const Placement tumbler = Placement::at(top + Vec3{-0.62f, 0.0f, -1.62f});
  add_lathe(pieces, tumbler, {{0.001f, 0.001f}, {0.030f, 0.001f}, {0.033f, 0.05f}, {0.036f, 0.115f}, {0.001f, 0.115f}},
            28, kGlass);
  const Placement carafe = Placement::at(top + Vec3{-0.70f, 0.0f, -1.82f});
  add_lathe(pieces, carafe,
            {{0.001f, 0.001f},
             {0.055f, 0.001f},
             {0.066f, 0.02f},
             {0.068f, 0.07f},
             {0.050f, 0.14f},
             {0.028f, 0.19f},
             {0.026f, 0.22f},
             {0.036f, 0.25f},
             {0.001f, 0.25f}},
            32, kGlass);
  const Placement cup = Placement::at(top + Vec3{-1.98f, 0.0f, -1.02f});
  add_lathe(pieces, cup, {{0.001f, 0.001f}, {0.038f, 0.001f}, {0.038f, 0.10f}, {0.035f, 0.10f}, {0.035f, 0.01f}}, 20,
            kChrome);
  const u32 inks[] = {kBookRed, kBookBlue, kBookGreen, kPlastic, kBrass};
  for (int i = 0; i < 5; ++i) {
    const Vec3 lean = 0.030f * on_circle(0.2 * i);
    add_tube(pieces, cup,
             {-0.5f * lean + Vec3{0, 0.012f, 0}, 0.2f * lean + Vec3{0, 0.08f, 0},
              lean + Vec3{0, 0.155f + 0.006f * static_cast<float>(i), 0}},
             0.0045f, {6, 2}, inks[i]);
  }
}

void add_papers(Pieces& pieces, Vec3 top) {
  Random random(9);
  for (int i = 0; i < 9; ++i) {
    const Placement sheet = Placement::at(top + Vec3{-1.62f, 0.003f * static_cast<float>(i), 0.32f},
                                          0.25 + random.between(-0.015f, 0.015f));
    add_block(pieces, sheet, {-0.105f, 0.0f, -0.148f}, {0.105f, 0.002f, 0.148f}, kPaper);
  }
  const Placement page = Placement::at(top + Vec3{-1.58f, 0.0f, -0.02f}, 0.27);
  const auto open_book = [=](float u, float v) {
    const float x = 0.4f * (u - 0.5f), out = 2.0f * larger(u - 0.5f, 0.5f - u);
    return page.point({x, 0.004f + 0.030f * out * (1.15f - out) * 3.0f, 0.13f - 0.26f * v});
  };
  add_sheet(pieces, open_book, {20, 1}, kPaper);
  add_block(pieces, page, {-0.205f, 0.0f, -0.135f}, {0.205f, 0.004f, 0.135f}, kBookBlue);
}

}  // namespace

void add_desk_things(Pieces& pieces) {
  const Vec3 top = {0.0f, kDeskTop, 0.0f};
  add_monitor(pieces, Placement::at(top + Vec3{-1.93f, 0.0f, -0.52f}, 0.235));
  add_keyboard(pieces, Placement::at(top + Vec3{-1.58f, 0.0f, -0.50f}, 0.245));
  add_lamp(pieces, Placement::at(top + Vec3{-2.02f, 0.0f, 0.30f}, -0.03));
  add_telephone(pieces, Placement::at(top + Vec3{-1.15f, 0.0f, -1.78f}, 0.05));
  add_vessels(pieces, top);
  add_papers(pieces, top);
}

}  // namespace raywalk::office
