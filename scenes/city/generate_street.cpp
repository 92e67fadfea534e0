// What lines the streets: trees, lamps, parked cars, markings; and the square in the middle.
#include "scenes/city/parts.h"
#include "scenes/common/noise.h"
#include "scenes/common/organic_surface.h"

namespace raywalk::city {
namespace {

void add_lamp(Pieces& pieces, Vec3 at, double turns) {
  const Placement place = Placement::at(at, turns);
  add_turned(pieces, place, {{0.10f, 0.0f}, {0.07f, 0.8f}, {0.05f, 3.5f}, {0.035f, 7.0f}}, kMetal, kSmooth);
  add_box(pieces, place, {-0.03f, 7.0f, -0.03f}, {1.6f, 7.06f, 0.03f}, kMetal, kFlat);
  add_box(pieces, place, {1.1f, 6.9f, -0.10f}, {1.7f, 7.0f, 0.10f}, kLamp, kFlat);
}

/// Along local x.
void add_car(Pieces& pieces, const Placement& place, u32 paint) {
  add_box(pieces, place, {-2.1f, 0.28f, -0.88f}, {2.1f, 0.85f, 0.88f}, paint, kFlat);
  add_box(pieces, place, {-1.3f, 0.85f, -0.78f}, {1.0f, 1.42f, 0.78f}, kWindow, kFlat);
  add_box(pieces, place, {-1.2f, 1.42f, -0.74f}, {0.9f, 1.46f, 0.74f}, paint, kFlat);
  for (const float x : {-1.35f, 1.35f}) {
    add_box(pieces, place, {x - 0.30f, 0.0f, -0.92f}, {x + 0.30f, 0.58f, 0.92f}, kRubber, kFlat);
  }
}

}  // namespace

void add_tree(Pieces& pieces, Vec3 at, float height, Random& random) {
  const float crown = 0.32f * height;
  add_turned(pieces, Placement::at(at),
             {{0.05f * height, 0.0f}, {0.03f * height, 0.1f * height}, {0.022f * height, 0.55f * height}}, kTrunk,
             kSmooth);
  const Vec3 offset = {random.between(0.0f, 90.0f), random.between(0.0f, 90.0f), random.between(0.0f, 90.0f)};
  const Vec3 centre = at + Vec3{0.0f, 0.68f * height, 0.0f};
  const auto shape = [=](Vec3 d, float spacing) {
    const auto point = [=](Vec3 e) {
      const float r = 1.0f + 0.45f * noise(1.6f * e + offset) + 0.22f * fractal_noise(6.0f * e + offset, 2);
      return centre + crown * r * Vec3{e.x, 1.15f * e.y, e.z};
    };
    const Vec3 u = normalized(cross(magnitude(d.y) < 0.9f ? Vec3{0.0f, 1.0f, 0.0f} : Vec3{1.0f, 0.0f, 0.0f}, d));
    const Vec3 v = cross(d, u);
    const float step = 0.4f * spacing;
    const Vec3 along_u = point(normalized(d + step * u)) - point(normalized(d - step * u));
    const Vec3 along_v = point(normalized(d + step * v)) - point(normalized(d - step * v));
    return SurfacePoint{point(d), normalized(cross(along_u, along_v))};
  };
  pieces.ball(shape, kLeaf, kSmooth * crown * crown);
}

void add_street(Pieces& pieces, Vec3 centre, Random& random) {
  const float edge = kHalfBlock - 1.2f;
  for (const float s : {-1.0f, 1.0f}) {
    add_lamp(pieces, centre + Vec3{s * edge, kKerb, s * 10.0f}, s > 0.0f ? 0.0 : 0.5);
    add_lamp(pieces, centre + Vec3{-s * 10.0f, kKerb, s * edge}, s > 0.0f ? 0.75 : 0.25);
    for (const float t : {-22.0f, 0.0f}) {
      const float height = random.between(5.5f, 9.0f);
      add_tree(pieces, centre + Vec3{s * (edge - 0.6f), kKerb, t - 4.0f}, height, random);
    }
    const float along = random.between(-24.0f, 24.0f);
    const u32 paint = kCarRed + random.below(3);
    add_car(pieces, Placement::at(centre + Vec3{s * (kHalfBlock + 1.6f), 0.0f, along}, 0.25), paint);
  }
  for (int i = 0; i < 8; ++i) {
    const float along = -35.0f + 10.0f * static_cast<float>(i);
    add_quad(pieces, centre + Vec3{0.5f * kPitch - 0.08f, 0.01f, along + 2.0f}, {0.16f, 0.0f, 0.0f},
             {0.0f, 0.0f, -4.0f}, kMarking, kFlat);
    add_quad(pieces, centre + Vec3{along - 2.0f, 0.01f, 0.5f * kPitch + 0.08f}, {4.0f, 0.0f, 0.0f},
             {0.0f, 0.0f, -0.16f}, kMarking, kFlat);
  }
}

void add_square(Pieces& pieces, Random& random) {
  add_box(pieces, Placement::at({}), {-24.0f, kKerb, -24.0f}, {24.0f, kKerb + 0.04f, 24.0f}, kGrass, kFlat);
  const float ground = kKerb + 0.04f;
  add_turned(pieces, Placement::at({0.0f, ground, 0.0f}), {{6.0f, 0.0f}, {6.0f, 0.12f}, {5.9f, 0.16f}, {0.01f, 0.16f}},
             kPavement, 8.0);
  add_box(pieces, Placement::at({0.0f, ground, 0.0f}, 0.125), {-1.2f, 0.1f, -1.2f}, {1.2f, 1.3f, 1.2f}, kConcrete,
          kFlat);
  constexpr float kScale = 1.5f;
  const Vec3 core = {0.0f, ground + 1.3f + 0.95f * kScale, 0.0f};
  const auto statue = [=](Vec3 d, float spacing) {
    const SurfacePoint p = organic_surface(d, spacing);
    return SurfacePoint{core + kScale * p.position, p.normal};
  };
  pieces.ball(statue, kBronze, 6000.0);
  for (int i = 0; i < 8; ++i) {
    const Placement around = Placement::at({}, (i + 0.5) / 8.0);
    const float height = random.between(6.0f, 9.5f);
    add_tree(pieces, around.point({17.0f, ground, 0.0f}), height, random);
  }
  // Balls from a metre down to a centimetre: a hundred thousandth of the city's size.
  float radius = 0.6f;
  for (int i = 0; i < 10; ++i) {
    const Placement around = Placement::at({}, 0.055 + 0.029 * i);
    add_sphere(pieces, around.point({4.2f - 0.12f * static_cast<float>(i), ground + 0.16f + radius, 0.0f}), radius,
               kChrome, kFine);
    radius *= 0.64f;
  }
}

}  // namespace raywalk::city
