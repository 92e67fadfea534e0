// Sink and tap, the oven under its hood, the refrigerator, and what stands on the hob.
#include <utility>

#include "scenes/kitchen/parts.h"

namespace raywalk::kitchen {
namespace {

void add_sink(Pieces& pieces) {
  const Placement place = on_far_wall(0.0f);
  const float x = kSinkX, z0 = 0.13f, z1 = 0.53f, deep = kSinkDeep, bottom = kTop - deep;
  const auto wall = [&](Vec3 corner, Vec3 u, Vec3 v) {
    add_quad(pieces, place.point(corner), place.direction(u), place.direction(v), kSteel, kFlat);
  };
  for (const float side : {-1.0f, 1.0f}) {
    // Two basins side by side.
    const float a = side < 0.0f ? -x : 0.012f, width = x - 0.012f;
    wall({a, bottom, z1}, {width, 0.0f, 0.0f}, {0.0f, 0.0f, z0 - z1});
    wall({a, bottom, z0}, {width, 0.0f, 0.0f}, {0.0f, deep, 0.0f});
    wall({a + width, bottom, z1}, {-width, 0.0f, 0.0f}, {0.0f, deep, 0.0f});
    wall({a, bottom, z1}, {0.0f, 0.0f, z0 - z1}, {0.0f, deep, 0.0f});
    wall({a + width, bottom, z0}, {0.0f, 0.0f, z1 - z0}, {0.0f, deep, 0.0f});
    add_ring(pieces, place.point({a + 0.5f * width, bottom + 0.002f, 0.5f * (z0 + z1)}), {0.0f, 1.0f, 0.0f}, 0.035f,
             0.006f, kChrome, 4.0 * kTiny);
  }
  add_box(pieces, place, {-0.012f, bottom, z0}, {0.012f, kTop, z1}, kSteel, kFlat);
  const float r = 0.008f;
  for (const float z : {z0, z1}) {
    add_rod(pieces, place.point({-x, kTop, z}), place.point({x, kTop, z}), r, kSteel, kTiny);
  }
  for (const float side : {-x, x}) {
    add_rod(pieces, place.point({side, kTop, z0}), place.point({side, kTop, z1}), r, kSteel, kTiny);
  }
  // The tap: a swan's neck between two cross handles.
  const auto at = [&](float y, float z) { return TubePoint{place.point({0.0f, kTop + y, z}), 0.013f}; };
  add_tube(pieces,
           {at(0.0f, 0.07f), at(0.18f, 0.07f), at(0.28f, 0.10f), at(0.31f, 0.17f), at(0.27f, 0.24f), at(0.20f, 0.25f)},
           kChrome, 6.0 * kTiny);
  add_turned(pieces, place.inner({0.0f, kTop, 0.07f}),
             {{0.032f, 0.0f}, {0.030f, 0.012f}, {0.016f, 0.03f}, {0.014f, 0.05f}}, kChrome, 4.0 * kTiny);
  for (const float side : {-0.11f, 0.11f}) {
    add_turned(pieces, place.inner({side, kTop, 0.07f}),
               {{0.024f, 0.0f}, {0.020f, 0.02f}, {0.011f, 0.03f}, {0.011f, 0.06f}, {0.001f, 0.066f}}, kChrome,
               4.0 * kTiny);
    const Vec3 hub = {side, kTop + 0.055f, 0.07f};
    add_rod(pieces, place.point(hub - Vec3{0.035f, 0.0f, 0.0f}), place.point(hub + Vec3{0.035f, 0.0f, 0.0f}), 0.006f,
            kChrome, 4.0 * kTiny);
    add_rod(pieces, place.point(hub - Vec3{0.0f, 0.0f, 0.035f}), place.point(hub + Vec3{0.0f, 0.0f, 0.035f}), 0.006f,
            kChrome, 4.0 * kTiny);
  }
}

void add_saucepan(Pieces& pieces, const Placement& place, float radius, float height, u32 material) {
  const float r = radius, h = height;
  add_turned(pieces, place,
             {{0.002f, 0.001f},
              {0.9f * r, 0.001f},
              {r, 0.02f},
              {r, 0.5f * h},
              {r, h},
              {1.04f * r, h + 0.006f},
              {1.02f * r, h + 0.01f}},
             material, kTiny);
  add_turned(pieces, place.inner({0.0f, h + 0.01f, 0.0f}),
             {{1.02f * r, 0.0f},
              {0.9f * r, 0.016f},
              {0.5f * r, 0.034f},
              {0.012f, 0.042f},
              {0.010f, 0.055f},
              {0.022f, 0.066f},
              {0.018f, 0.078f},
              {0.001f, 0.08f}},
             material, kTiny);
  for (const float side : {-1.0f, 1.0f}) {
    const auto at = [&](float x, float z) { return TubePoint{place.point({side * x, 0.75f * h, z}), 0.007f}; };
    add_tube(pieces, {at(0.98f * r, -0.04f), at(r + 0.035f, -0.03f), at(r + 0.035f, 0.03f), at(0.98f * r, 0.04f)},
             kChrome, 3.0 * kTiny);
  }
}

void add_kettle(Pieces& pieces, const Placement& place) {
  add_turned(pieces, place,
             {{0.002f, 0.001f},
              {0.095f, 0.001f},
              {0.115f, 0.02f},
              {0.112f, 0.07f},
              {0.085f, 0.13f},
              {0.045f, 0.155f},
              {0.040f, 0.165f},
              {0.012f, 0.172f},
              {0.009f, 0.185f},
              {0.018f, 0.196f},
              {0.001f, 0.206f}},
             kChrome, 2.0 * kTiny);
  const auto at = [&](float x, float y, float r) { return TubePoint{place.point({x, y, 0.0f}), r}; };
  add_tube(
      pieces,
      {at(0.085f, 0.06f, 0.024f), at(0.13f, 0.085f, 0.018f), at(0.155f, 0.125f, 0.012f), at(0.18f, 0.145f, 0.011f)},
      kChrome, 3.0 * kTiny);
  add_tube(pieces,
           {at(0.07f, 0.13f, 0.006f), at(0.075f, 0.21f, 0.008f), at(0.0f, 0.26f, 0.011f), at(-0.075f, 0.21f, 0.008f),
            at(-0.07f, 0.13f, 0.006f)},
           kRubber, 3.0 * kTiny);
}

void add_oven(Pieces& pieces) {
  const Placement place = on_left_wall(1.55f - 2.0f * kUnit);
  add_box(pieces, place, {0.005f, 0.0f, 0.0f}, {kUnit - 0.005f, kTop, 0.58f}, kEnamel, kFlat);
  add_box(pieces, place, {0.03f, 0.20f, 0.58f}, {kUnit - 0.03f, 0.70f, 0.605f}, kEnamel, kFlat);
  add_box(pieces, place, {0.09f, 0.26f, 0.605f}, {kUnit - 0.09f, 0.60f, 0.609f}, kBlackGlass, kFlat);
  add_handle(pieces, place, {0.07f, 0.655f, 0.605f}, {kUnit - 0.07f, 0.655f, 0.605f}, 0.05f);
  add_box(pieces, place, {0.005f, 0.74f, 0.58f}, {kUnit - 0.005f, kTop, 0.60f}, kSteel, kFlat);
  for (int i = 0; i < 5; ++i) {
    const Vec3 knob = {0.09f + 0.11f * static_cast<float>(i), 0.82f, 0.60f};
    add_rod(pieces, place.point(knob), place.point(knob + Vec3{0.0f, 0.0f, 0.028f}), 0.022f, kIron, kTiny);
  }
  // Four burners under their grates.
  add_box(pieces, place, {0.005f, kTop, 0.0f}, {kUnit - 0.005f, kTop + 0.012f, 0.60f}, kBlackGlass, kFlat);
  for (const float x : {0.17f, 0.45f}) {
    for (const float z : {0.17f, 0.44f}) {
      const Vec3 centre = place.point({x, kTop + 0.02f, z});
      for (const float r : {0.035f, 0.075f, 0.11f}) {
        add_ring(pieces, centre + Vec3{0.0f, 0.012f, 0.0f}, {0.0f, 1.0f, 0.0f}, r, 0.006f, kIron, kTiny);
      }
      for (const Vec3 d : {Vec3{0.11f, 0.0f, 0.0f}, Vec3{0.0f, 0.0f, 0.11f}}) {
        add_rod(pieces, centre + Vec3{0.0f, 0.012f, 0.0f} - d, centre + Vec3{0.0f, 0.012f, 0.0f} + d, 0.006f, kIron,
                kTiny);
      }
    }
  }
  add_saucepan(pieces, place.inner({0.17f, kTop + 0.038f, 0.17f}), 0.12f, 0.15f, kSteel);
  add_saucepan(pieces, place.inner({0.45f, kTop + 0.038f, 0.44f}, 0.1), 0.10f, 0.10f, kCopper);
  add_kettle(pieces, place.inner({0.17f, kTop + 0.038f, 0.44f}, 0.65));
}

/// A hood that narrows to its flue.
void add_hood(Pieces& pieces) {
  const Placement place = on_left_wall(1.55f - 2.5f * kUnit);
  struct Section {
    float half, deep, y;
  };
  const Section low = {0.36f, 0.55f, 1.62f}, edge = {0.36f, 0.55f, 1.70f}, high = {0.14f, 0.28f, 2.16f},
                flue = {0.14f, 0.28f, kHeight - 0.02f};
  const auto band = [&](const Section& a, const Section& b) {
    const auto side = [&](Vec3 p, Vec3 q, Vec3 r, Vec3 s) {
      const Vec3 normal = place.direction(normalized(cross(q - p, s - p)));
      pieces.patch(
          [=](float u, float v) {
            return SurfacePoint{place.point(p + u * (q - p) + v * ((1.0f - u) * (s - p) + u * (r - q))), normal};
          },
          1.0f, kSteel, kFlat);
    };
    side({-a.half, a.y, a.deep}, {a.half, a.y, a.deep}, {b.half, b.y, b.deep}, {-b.half, b.y, b.deep});
    side({a.half, a.y, a.deep}, {a.half, a.y, 0.0f}, {b.half, b.y, 0.0f}, {b.half, b.y, b.deep});
    side({-a.half, a.y, 0.0f}, {-a.half, a.y, a.deep}, {-b.half, b.y, b.deep}, {-b.half, b.y, 0.0f});
  };
  band(low, edge);
  band(edge, high);
  band(high, flue);
  add_quad(pieces, place.point({-0.36f, low.y, 0.0f}), place.direction({0.72f, 0.0f, 0.0f}),
           place.direction({0.0f, 0.0f, 0.55f}), kIron, kFlat);
  add_rod(pieces, place.point({-0.37f, 1.64f, 0.57f}), place.point({0.37f, 1.64f, 0.57f}), 0.012f, kChrome, kTiny);
}

void add_refrigerator(Pieces& pieces) {
  const Placement place = on_left_wall(2.44f);
  add_box(pieces, place, {0.0f, 0.0f, 0.0f}, {0.84f, 2.0f, 0.62f}, kSteel, kFlat);
  for (const auto& [y0, y1] : {std::pair{0.08f, 1.25f}, std::pair{1.265f, 1.99f}}) {
    add_cushion(pieces, place, {0.42f, 0.5f * (y0 + y1), 0.64f}, {0.42f, 0.5f * (y1 - y0), 0.05f}, kSteel, kSmooth);
  }
  add_handle(pieces, place, {0.08f, 0.80f, 0.675f}, {0.08f, 1.18f, 0.675f}, 0.05f);
  add_handle(pieces, place, {0.08f, 1.33f, 0.675f}, {0.08f, 1.60f, 0.675f}, 0.05f);
}

}  // namespace

void add_appliances(Pieces& pieces) {
  add_sink(pieces);
  add_oven(pieces);
  add_hood(pieces);
  add_refrigerator(pieces);
}

}  // namespace raywalk::kitchen
