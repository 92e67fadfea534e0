// The oval table, its pedestals, and papers, glasses and microphones for everyone.
#include <array>

#include "scenes/conference/parts.h"

namespace raywalk::conference {
namespace {

constexpr float kHalfTable = 3.45f, kHalfAcross = 1.12f;

/// A circle pulled towards its square.
Vec3 rim(double t) {
  const float c = static_cast<float>(cosine_turns(t)), s = static_cast<float>(sine_turns(t));
  const float c2 = c * c, s2 = s * s;
  const float unit = 1.0f / square_root(square_root(c2 * c2 + s2 * s2));
  return {kHalfTable * unit * c, 0.0f, -kHalfAcross * unit * s};
}

Vec3 outwards(double t) {
  const Vec3 along = rim(t + 1e-3) - rim(t - 1e-3);
  return normalized({-along.z, 0.0f, along.x});
}

void add_body(Pieces& pieces) {
  const Placement here;
  const auto outline = [](float out) { return [=](float t) { return on_table(static_cast<double>(t), out); }; };
  add_slab(pieces, here, outline(-0.02f), {}, kTableTop - 0.05f, kTableTop, 160, kTable);
  add_slab(pieces, here, outline(-0.26f), {}, kTableTop, kTableTop + 0.001f, 160, kInlay);
  add_slab(pieces, here, outline(-0.30f), {}, kTableTop + 0.001f, kTableTop + 0.002f, 160, kTable);
  const auto edge = [](float u, float v) {
    const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
    return on_table(static_cast<double>(1.0f - v), -0.02f + 0.025f * c) +
           Vec3{0.0f, kTableTop - 0.025f + 0.025f * s, 0.0f};
  };
  add_sheet(pieces, edge, {12, 160}, kTable);
  for (const float x : {-2.1f, 0.0f, 2.1f}) {
    const Placement foot = Placement::at({x, 0.0f, 0.0f});
    add_pad(pieces, foot, {0.0f, 0.035f, 0.0f}, {0.42f, 0.035f, 0.46f}, 0.025f, kShell, 3);
    add_lathe(pieces, foot,
              {{0.34f, 0.06f},
               {0.31f, 0.10f},
               {0.22f, 0.16f},
               {0.19f, 0.22f},
               {0.18f, 0.50f},
               {0.22f, 0.60f},
               {0.36f, 0.66f},
               {0.40f, 0.69f}},
              40, kShell);
  }
}

/// What lies before one seat: +z looks to the middle of the table.
void add_setting(Pieces& pieces, const Placement& place, Random& random) {
  const Placement pad = place.inner({random.between(-0.04f, 0.04f), 0.0f, 0.20f}, random.between(-0.015f, 0.015f));
  add_block(pieces, pad, {-0.105f, 0.0f, -0.14f}, {0.105f, 0.006f, 0.14f}, kPaper);
  add_block(pieces, pad, {-0.105f, 0.006f, 0.115f}, {0.105f, 0.009f, 0.14f}, kBlue);
  const Placement pen = pad.inner({0.12f, 0.011f, 0.0f}, random.between(-0.04f, 0.04f));
  add_tube(pieces, pen, {{0.0f, 0.0f, -0.07f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.07f}}, 0.0045f, {8, 3}, kChrome);

  const Placement glass = place.inner({-0.22f, 0.0f, 0.36f + random.between(-0.03f, 0.03f)});
  add_lathe(pieces, glass,
            {{0.001f, 0.0005f}, {0.028f, 0.0005f}, {0.031f, 0.01f}, {0.034f, 0.06f}, {0.036f, 0.11f}, {0.001f, 0.112f}},
            24, kGlass);

  const Placement microphone = place.inner({0.10f, 0.0f, 0.46f});
  add_lathe(pieces, microphone,
            {{0.055f, 0.0f}, {0.055f, 0.012f}, {0.046f, 0.024f}, {0.014f, 0.030f}, {0.012f, 0.045f}}, 20, kPlastic);
  add_tube(pieces, microphone, {{0.0f, 0.04f, 0.0f}, {0.0f, 0.14f, 0.02f}, {0.0f, 0.22f, 0.0f}, {0.0f, 0.27f, -0.07f}},
           0.0045f, {8, 12}, kChrome);
  add_cushion(pieces, microphone, {0.0f, 0.28f, -0.095f}, {0.014f, 0.014f, 0.032f}, kPlastic, 100.0 / 0.0176);

  const Vec3 card = place.point({-0.06f, 0.0f, 0.44f});
  const Vec3 across = place.direction({0.20f, 0.0f, 0.0f}), back = place.direction({0.0f, 0.0f, 0.035f});
  const Vec3 up = {0.0f, 0.075f, 0.0f};
  add_plate(pieces, card - 0.5f * across - back + Vec3{0, 0.001f, 0}, across, up + back, kPaper);
  add_plate(pieces, card + 0.5f * across + back + Vec3{0, 0.001f, 0}, -across, up - back, kPaper);
}

void add_carafe(Pieces& pieces, Vec3 at) {
  add_lathe(pieces, Placement::at(at), {{0.16f, 0.0f}, {0.165f, 0.006f}, {0.15f, 0.010f}, {0.001f, 0.010f}}, 40,
            kChrome);
  add_lathe(pieces, Placement::at(at + Vec3{0.0f, 0.011f, 0.0f}),
            {{0.001f, 0.0005f},
             {0.055f, 0.0005f},
             {0.066f, 0.02f},
             {0.068f, 0.08f},
             {0.052f, 0.15f},
             {0.030f, 0.20f},
             {0.027f, 0.23f},
             {0.038f, 0.27f},
             {0.001f, 0.272f}},
            36, kGlass);
}

void add_flowers(Pieces& pieces, Vec3 at) {
  add_lathe(pieces, Placement::at(at),
            {{0.05f, 0.0f},
             {0.06f, 0.01f},
             {0.11f, 0.05f},
             {0.12f, 0.09f},
             {0.09f, 0.13f},
             {0.08f, 0.14f},
             {0.07f, 0.13f},
             {0.001f, 0.11f}},
            36, kPorcelain);
  Random random(77);
  for (int i = 0; i < 26; ++i) {
    const double turns = 0.381966 * i;
    const float out = 0.03f + 0.15f * random.unit(), high = 0.34f - 0.9f * out + random.between(-0.02f, 0.03f);
    const Vec3 tip = {out * static_cast<float>(cosine_turns(turns)), high, out * static_cast<float>(sine_turns(turns))};
    add_tube(pieces, Placement::at(at),
             {{0.2f * tip.x, 0.11f, 0.2f * tip.z}, {0.5f * tip.x, 0.7f * high, 0.5f * tip.z}, tip}, 0.003f, {5, 4},
             kLeaf);
    const Vec3 centre = at + tip;
    const auto blossom = [=](Vec3 d, float) {
      const float petal = 1.0f + 0.22f * static_cast<float>(sine_turns(1.4 * d.x + 0.3) * sine_turns(1.4 * d.z) +
                                                            sine_turns(1.1 * d.y) * cosine_turns(1.3 * d.x));
      return SurfacePoint{centre + 0.034f * petal * d, d};
    };
    pieces.ball(blossom, i % 3 == 0 ? kPorcelain : i % 3 == 1 ? kOrange : kBlue, 100.0);
  }
}

}  // namespace

Vec3 on_table(double t, float out) {
  return rim(t) + out * outwards(t);
}

Seat seat_at(int i) {
  // Even steps along a line around the rim, from a polygon of many corners.
  constexpr int kCorners = 1440;
  std::array<float, kCorners + 1> way{};
  for (int k = 0; k < kCorners; ++k) {
    const Vec3 a = on_table(static_cast<double>(k) / kCorners, 0.4f);
    const Vec3 b = on_table(static_cast<double>(k + 1) / kCorners, 0.4f);
    way[k + 1] = way[k] + length(b - a);
  }
  const float wanted = way[kCorners] * (static_cast<float>(i) + 0.5f) / kSeats;
  int k = 0;
  while (way[k + 1] < wanted) ++k;
  const double t = (k + static_cast<double>((wanted - way[k]) / (way[k + 1] - way[k]))) / kCorners;
  const Vec3 in = -outwards(t);
  // The angle whose sine and cosine are in.x and in.z, by halving.
  double turns = 0.0;
  for (double step = 0.25; step > 1e-9; step *= 0.5) {
    const auto agreement = [&](double at) { return sine_turns(at) * in.x + cosine_turns(at) * in.z; };
    for (const double other : {turns + step, turns - step}) {
      if (agreement(other) > agreement(turns)) turns = other;
    }
  }
  return {rim(t), in, turns};
}

void add_table(Pieces& pieces) {
  add_body(pieces);
  Random random(4);
  for (int i = 0; i < kSeats; ++i) {
    const Seat seat = seat_at(i);
    add_setting(pieces, Placement::at(seat.rim + Vec3{0.0f, kTableTop + 0.002f, 0.0f}, seat.turns), random);
  }
  for (const float x : {-2.4f, -1.2f, 1.2f, 2.4f}) add_carafe(pieces, {x, kTableTop + 0.002f, 0.0f});
  add_flowers(pieces, {0.0f, kTableTop + 0.002f, 0.0f});
}

}  // namespace raywalk::conference
