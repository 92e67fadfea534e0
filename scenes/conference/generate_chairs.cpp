// Two dozen swivel chairs around the table.
#include "scenes/conference/parts.h"

namespace raywalk::conference {
namespace {

/// A cushion whose sides come forward by `bend` a metre squared and whose top leans back by `lean` a metre.
void add_bent_cushion(Pieces& pieces, const Placement& place, Vec3 centre, Vec3 half, float bend, float lean,
                      u32 material, double triangles) {
  const auto shape = [=](Vec3 d, float) {
    const Vec3 d2 = d * d;
    const Vec3 unit = d * (1.0f / square_root(square_root(dot(d2, d2))));
    const Vec3 cube = unit * unit * unit;
    const Vec3 p = half * unit, n = {cube.x / half.x, cube.y / half.y, cube.z / half.z};
    const Vec3 bent = {p.x, p.y, p.z + bend * p.x * p.x - lean * p.y};
    const Vec3 normal = {n.x - 2.0f * bend * p.x * n.z, n.y + lean * n.z, n.z};
    return SurfacePoint{place.point(centre + bent), place.direction(normalized(normal))};
  };
  pieces.ball(shape, material, triangles - static_cast<double>(kLeastBallTriangles));
}

void add_base(Pieces& pieces, const Placement& place) {
  for (int i = 0; i < 5; ++i) {
    const Placement arm = place.inner({}, 0.2 * i);
    const auto leg = [=](float u, float v) {
      const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
      const float thick = 0.026f - 0.010f * v;
      return arm.point({thick * s, 0.125f - 0.045f * v * v + 0.8f * thick * c, 0.03f + 0.28f * v});
    };
    add_sheet(
        pieces, [=](float u, float v) { return leg(1.0f - u, v); }, {10, 6}, kChrome);
    add_lathe(pieces, arm.inner({0.0f, 0.0f, 0.305f}), {{0.011f, 0.03f}, {0.013f, 0.085f}, {0.001f, 0.092f}}, 12,
              kChrome);
    for (const float x : {-0.017f, 0.017f}) {
      add_bent_cushion(pieces, arm, {x, 0.028f, 0.305f}, {0.012f, 0.028f, 0.028f}, 0.0f, 0.0f, kPlastic, 80);
    }
  }
  add_lathe(pieces, place,
            {{0.052f, 0.085f},
             {0.054f, 0.15f},
             {0.046f, 0.17f},
             {0.030f, 0.18f},
             {0.030f, 0.30f},
             {0.020f, 0.305f},
             {0.020f, 0.41f},
             {0.10f, 0.43f}},
            18, kChrome);
}

/// Faces local +z.
void add_chair(Pieces& pieces, const Placement& place) {
  add_base(pieces, place);
  add_pad(pieces, place, {0.0f, 0.437f, 0.01f}, {0.23f, 0.014f, 0.22f}, 0.012f, kShell, 2);
  add_bent_cushion(pieces, place, {0.0f, 0.49f, 0.02f}, {0.255f, 0.05f, 0.25f}, 0.0f, 0.0f, kLeather, 1234);
  add_bent_cushion(pieces, place, {0.0f, 0.80f, -0.245f}, {0.245f, 0.25f, 0.04f}, 0.9f, 0.16f, kLeather, 1234);
  add_bent_cushion(pieces, place, {0.0f, 0.665f, -0.195f}, {0.20f, 0.075f, 0.035f}, 0.9f, 0.16f, kLeather, 500);
  // The wooden shell behind the back.
  const auto shell = [=](float u, float v) {
    const float x = 0.265f * (2.0f * u - 1.0f) * (0.93f + 0.07f * static_cast<float>(sine_turns(0.5 * v)));
    const float y = 0.50f + 0.58f * v - 0.10f * v * x * x * 14.0f;
    return place.point({x, y, -0.29f + 0.9f * x * x - 0.16f * (y - 0.80f)});
  };
  add_sheet(
      pieces, [=](float u, float v) { return shell(1.0f - u, v); }, {16, 14}, kShell);
  add_tube(pieces, place,
           {{0.0f, 0.425f, -0.05f}, {0.0f, 0.42f, -0.22f}, {0.0f, 0.47f, -0.27f}, {0.0f, 0.66f, -0.285f}}, 0.020f,
           {12, 14}, kChrome);
  for (const float side : {-1.0f, 1.0f}) {
    add_tube(pieces, place,
             {{0.16f * side, 0.43f, 0.08f},
              {0.28f * side, 0.44f, 0.09f},
              {0.315f * side, 0.50f, 0.12f},
              {0.315f * side, 0.645f, 0.14f},
              {0.31f * side, 0.665f, 0.06f},
              {0.30f * side, 0.66f, -0.16f},
              {0.25f * side, 0.68f, -0.245f}},
             0.013f, {10, 24}, kChrome);
    add_pad(pieces, place, {0.31f * side, 0.685f, 0.0f}, {0.030f, 0.014f, 0.14f}, 0.013f, kShell, 2);
  }
}

}  // namespace

void add_chairs(Pieces& pieces) {
  Random random(8);
  for (int i = 0; i < kSeats; ++i) {
    const Seat seat = seat_at(i);
    const float away = 0.30f + random.between(0.0f, 0.22f);
    const double turned = seat.turns + random.between(-0.035f, 0.035f);
    add_chair(pieces, Placement::at(seat.rim - away * seat.inwards, turned));
  }
}

}  // namespace raywalk::conference
