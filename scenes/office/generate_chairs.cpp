// The swivel chair, an armchair and a glass table beside it.
#include "scenes/office/parts.h"

namespace raywalk::office {
namespace {

/// Faces local +z.
void add_swivel_chair(Pieces& pieces, const Placement& place) {
  for (int i = 0; i < 5; ++i) {
    const Placement arm = place.inner({}, 0.2 * i);
    add_tube(pieces, arm, {{0.0f, 0.13f, 0.02f}, {0.0f, 0.115f, 0.16f}, {0.0f, 0.085f, 0.31f}}, 0.020f, {10, 6},
             kChrome);
    add_lathe(pieces, arm.inner({0.0f, 0.05f, 0.31f}), {{0.012f, -0.01f}, {0.012f, 0.05f}}, 8, kPlastic);
    for (const float x : {-0.016f, 0.016f}) {
      add_cushion(pieces, arm, {x, 0.028f, 0.31f}, {0.011f, 0.028f, 0.028f}, kPlastic, 0.0);
    }
  }
  add_lathe(pieces, place,
            {{0.045f, 0.09f}, {0.045f, 0.16f}, {0.032f, 0.17f}, {0.032f, 0.29f}, {0.018f, 0.295f}, {0.018f, 0.43f}}, 16,
            kChrome);
  add_block(pieces, place, {-0.11f, 0.415f, -0.12f}, {0.11f, 0.445f, 0.12f}, kPlastic);
  add_cushion(pieces, place, {0.0f, 0.49f, 0.02f}, {0.25f, 0.05f, 0.25f}, kLeather, kSoft);
  // The back is a cushion in three parts, one above the other.
  for (int i = 0; i < 3; ++i) {
    const float step = static_cast<float>(i);
    add_cushion(pieces, place, {0.0f, 0.66f + 0.19f * step, -0.245f - 0.022f * step},
                {0.235f - 0.015f * step, 0.105f, 0.048f}, kLeather, kSoft);
  }
  add_tube(pieces, place, {{0.0f, 0.43f, -0.10f}, {0.0f, 0.43f, -0.28f}, {0.0f, 0.56f, -0.315f}, {0.0f, 0.95f, -0.32f}},
           0.022f, {10, 12}, kChrome);
  for (const float side : {-1.0f, 1.0f}) {
    add_tube(pieces, place,
             {{0.12f * side, 0.43f, 0.06f},
              {0.27f * side, 0.45f, 0.06f},
              {0.295f * side, 0.56f, 0.06f},
              {0.295f * side, 0.69f, 0.03f}},
             0.014f, {8, 12}, kChrome);
    add_pad(pieces, place, {0.295f * side, 0.70f, 0.0f}, {0.035f, 0.018f, 0.14f}, 0.016f, kPlastic, 2);
  }
}

/// Faces local +z.
void add_armchair(Pieces& pieces, const Placement& place) {
  add_cushion(pieces, place, {0.0f, 0.25f, 0.0f}, {0.36f, 0.10f, 0.34f}, kFabric, 0.5 * kSoft);
  add_cushion(pieces, place, {0.0f, 0.40f, 0.05f}, {0.27f, 0.075f, 0.31f}, kFabric, kSoft);
  add_cushion(pieces, place, {0.0f, 0.60f, -0.28f}, {0.36f, 0.30f, 0.09f}, kFabric, kSoft);
  for (const float side : {-1.0f, 1.0f}) {
    add_cushion(pieces, place, {0.34f * side, 0.38f, 0.0f}, {0.08f, 0.20f, 0.35f}, kFabric, kSoft);
    for (const float z : {-0.28f, 0.28f}) {
      add_lathe(pieces, place.inner({0.32f * side, 0.0f, z}), {{0.016f, 0.0f}, {0.026f, 0.16f}}, 10, kWood);
    }
  }
  const Placement pillow = place.inner({0.03f, 0.60f, -0.13f}, 0.02);
  add_cushion(pieces, pillow, {}, {0.19f, 0.15f, 0.06f}, kBookRed, kSoft);
}

void add_glass_table(Pieces& pieces, Vec3 at) {
  const Placement place = Placement::at(at);
  add_slab(
      pieces, place, [](float t) { return 0.29f * on_circle(t); }, {}, 0.448f, 0.46f, 48, kGlass);
  add_lathe(pieces, place,
            {{0.17f, 0.0f},
             {0.17f, 0.012f},
             {0.05f, 0.022f},
             {0.022f, 0.04f},
             {0.018f, 0.40f},
             {0.10f, 0.44f},
             {0.10f, 0.447f}},
            24, kChrome);
  const Placement book = place.inner({-0.05f, 0.46f, 0.02f}, 0.1);
  add_block(pieces, book, {-0.12f, 0.0f, -0.09f}, {0.12f, 0.022f, 0.09f}, kBookBlue);
  add_block(pieces, book.inner({0.01f, 0.022f, 0.0f}, 0.04), {-0.10f, 0.0f, -0.08f}, {0.10f, 0.018f, 0.08f},
            kBookCream);
  add_sphere(pieces, place.point({0.11f, 0.51f, -0.12f}), 0.05f, kGlass, 20'000.0);
}

}  // namespace

void add_chairs(Pieces& pieces) {
  add_swivel_chair(pieces, Placement::at({-0.95f, 0.0f, -0.42f}, -0.19));
  add_armchair(pieces, Placement::at({-1.55f, 0.0f, 1.58f}, 0.36));
  add_glass_table(pieces, {-0.72f, 0.0f, 1.80f});
}

}  // namespace raywalk::office
