// What stands around: glass and fruit on the table, lamps, a plant, a statue on its pedestal.
#include "scenes/common/organic_surface.h"
#include "scenes/room/parts.h"

namespace raywalk::room {
namespace {

void add_table_setting(Pieces& pieces) {
  const Vec3 top = kTableCentre + Vec3{0.0f, kTableTop, 0.0f};
  add_sphere(pieces, top + Vec3{-0.40f, 0.115f, 0.12f}, 0.115f, kGlass, kFine);
  add_sphere(pieces, top + Vec3{-0.14f, 0.060f, 0.27f}, 0.060f, kChrome, kFine);

  // Outside up, over the lip, inside down.
  const std::vector<ProfilePoint> vase = {{0.002f, 0.001f}, {0.055f, 0.001f}, {0.062f, 0.02f}, {0.095f, 0.11f},
                                          {0.080f, 0.20f},  {0.038f, 0.27f},  {0.036f, 0.31f}, {0.058f, 0.35f},
                                          {0.055f, 0.352f}, {0.031f, 0.31f},  {0.033f, 0.27f}, {0.074f, 0.20f},
                                          {0.088f, 0.11f},  {0.055f, 0.025f}, {0.002f, 0.015f}};
  add_turned(pieces, Placement::at(top + Vec3{0.52f, 0.0f, -0.12f}), vase, kCeramic, kSmooth);

  const Vec3 bowl_at = top + Vec3{0.12f, 0.0f, -0.06f};
  const std::vector<ProfilePoint> bowl = {{0.002f, 0.002f}, {0.060f, 0.002f}, {0.065f, 0.012f},
                                          {0.120f, 0.035f}, {0.165f, 0.085f}, {0.160f, 0.087f},
                                          {0.115f, 0.045f}, {0.060f, 0.022f}, {0.002f, 0.018f}};
  add_turned(pieces, Placement::at(bowl_at), bowl, kBowl, kSmooth);
  const Vec3 fruit[] = {
      {-0.055f, 0.067f, 0.035f}, {0.055f, 0.067f, 0.035f}, {0.0f, 0.069f, -0.060f}, {0.004f, 0.128f, 0.006f}};
  for (int i = 0; i < 4; ++i) add_sphere(pieces, bowl_at + fruit[i], 0.044f, i % 2 ? kApple : kOrange, kSmooth);

  const std::vector<ProfilePoint> tumbler = {{0.002f, 0.001f}, {0.030f, 0.001f},  {0.034f, 0.06f},
                                             {0.038f, 0.115f}, {0.0365f, 0.117f}, {0.035f, 0.112f},
                                             {0.031f, 0.06f},  {0.027f, 0.014f},  {0.002f, 0.012f}};
  add_turned(pieces, Placement::at(top + Vec3{0.38f, 0.0f, 0.26f}), tumbler, kGlass, kFine);
  const Placement books = Placement::at(top + Vec3{-0.55f, 0.0f, -0.22f}, 0.06);
  add_box(pieces, books, {-0.12f, 0.0f, -0.085f}, {0.12f, 0.03f, 0.085f}, kBookRed, kFlat);
  add_box(pieces, books.inner({0.0f, 0.03f, 0.0f}, 0.04), {-0.11f, 0.0f, -0.08f}, {0.11f, 0.025f, 0.08f}, kBookCream,
          kFlat);
}

void add_lamps(Pieces& pieces) {
  const std::vector<ProfilePoint> dome = {
      {0.25f, 0.0f}, {0.235f, 0.06f}, {0.18f, 0.135f}, {0.09f, 0.18f}, {0.03f, 0.20f}};
  const Vec3 pendant = kTableCentre + Vec3{0.0f, 1.78f, 0.0f};
  add_turned(pieces, Placement::at(pendant), dome, kMetal, kSmooth);
  add_turned(pieces, Placement::at(pendant), {{0.006f, 0.19f}, {0.006f, 0.5f}, {0.006f, kHeight - 1.78f}}, kMetal,
             kSmooth);
  add_sphere(pieces, pendant + Vec3{0.0f, 0.12f, 0.0f}, 0.045f, kTrim, kSmooth);

  const Placement floor_lamp = Placement::at({kLeftX + 0.42f, 0.0f, 1.75f});
  add_turned(pieces, floor_lamp, {{0.002f, 0.03f}, {0.06f, 0.028f}, {0.14f, 0.012f}, {0.15f, 0.0f}}, kMetal, kSmooth);
  add_turned(pieces, floor_lamp, {{0.011f, 0.02f}, {0.010f, 0.7f}, {0.009f, 1.44f}}, kMetal, kSmooth);
  add_turned(pieces, floor_lamp, {{0.22f, 1.36f}, {0.19f, 1.50f}, {0.15f, 1.66f}}, kShade, kSmooth);
  add_sphere(pieces, floor_lamp.point({0.0f, 1.46f, 0.0f}), 0.035f, kTrim, kSmooth);
}

/// One arching leaf that starts in `root`; `turns` is its direction.
void add_leaf(Pieces& pieces, Vec3 root, double turns, float reach, float rise) {
  const Placement place = Placement::at(root, turns);
  const auto middle = [=](float v) {
    return Vec3{reach * v * (0.35f + 0.65f * v), rise * v * (1.9f - 1.15f * v), 0.0f};
  };
  const auto shape = [=](float u, float v) {
    const float half_width = 0.30f * reach * v * (1.0f - v) * (1.6f - 0.8f * v) + 0.002f;
    const float across = 2.0f * u - 1.0f;
    const auto at = [=](float s, float t) {
      // The halves stand up a little from the middle rib.
      return middle(t) + Vec3{0.0f, 0.25f * half_width * s * s, -half_width * s};
    };
    constexpr float kStep = 1e-2f;
    const Vec3 du = at(across + kStep, v) - at(across - kStep, v), dv = at(across, v + kStep) - at(across, v - kStep);
    return SurfacePoint{place.point(at(across, v)), place.direction(normalized(cross(du, dv)))};
  };
  pieces.patch(shape, 0.35f, kLeaf, 2.5 * reach * reach);
}

void add_plant(Pieces& pieces) {
  const Vec3 at = {kRightX - 0.50f, 0.0f, kFrontZ + 0.50f};
  const std::vector<ProfilePoint> pot = {{0.002f, 0.001f}, {0.13f, 0.001f}, {0.15f, 0.05f}, {0.19f, 0.34f},
                                         {0.205f, 0.38f},  {0.185f, 0.38f}, {0.17f, 0.33f}, {0.002f, 0.32f}};
  add_turned(pieces, Placement::at(at), pot, kPot, kSmooth);
  Random random(11);
  for (int i = 0; i < 44; ++i) {
    const double turns = 0.381966 * i + random.between(-0.03f, 0.03f);
    const float young = static_cast<float>(i) / 44.0f;
    const float reach = random.between(0.30f, 0.42f) * (1.0f - 0.55f * young);
    const float rise = 0.30f + 0.75f * young + random.between(0.0f, 0.12f);
    add_leaf(pieces, at + Vec3{0.0f, 0.32f, 0.0f}, turns, reach, rise);
  }
}

void add_statue(Pieces& pieces) {
  const Vec3 at = {kLeftX + 0.62f, 0.0f, kFrontZ + 0.60f};
  const Placement place = Placement::at(at);
  add_box(pieces, place, {-0.22f, 0.0f, -0.22f}, {0.22f, 0.07f, 0.22f}, kStone, kFlat);
  add_box(pieces, place, {-0.17f, 0.07f, -0.17f}, {0.17f, 0.86f, 0.17f}, kStone, kFlat);
  add_box(pieces, place, {-0.21f, 0.86f, -0.21f}, {0.21f, 0.91f, 0.21f}, kStone, kFlat);
  constexpr float kScale = 0.25f;
  const Vec3 core = at + Vec3{0.0f, 0.91f + 0.97f * kScale, 0.0f};
  const auto shape = [=](Vec3 d, float spacing) {
    const SurfacePoint p = organic_surface(d, spacing);
    return SurfacePoint{core + kScale * p.position, p.normal};
  };
  pieces.ball(shape, kBronze, 50.0);
}

}  // namespace

void add_ornaments(Pieces& pieces) {
  add_table_setting(pieces);
  add_lamps(pieces);
  add_plant(pieces);
  add_statue(pieces);
}

}  // namespace raywalk::room
