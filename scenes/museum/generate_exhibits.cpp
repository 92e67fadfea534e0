// What is shown: a bronze knot on its plinth behind a rope, glass and chrome on pedestals; and benches.
#include "scenes/museum/parts.h"

namespace raywalk::museum {
namespace {

/// The trefoil knot on a torus that stands upright, about one unit wide.
Vec3 trefoil(double turns) {
  const float radius = 0.72f + 0.30f * static_cast<float>(cosine_turns(3.0 * turns));
  return {radius * static_cast<float>(cosine_turns(2.0 * turns)), radius * static_cast<float>(sine_turns(2.0 * turns)),
          0.34f * static_cast<float>(sine_turns(3.0 * turns))};
}

/// A band around the curve whose section is an oval that turns along with it.
SurfacePoint on_knot(double around, double along) {
  constexpr double kStep = 1e-3;
  const Vec3 tangent = normalized(trefoil(along + kStep) - trefoil(along - kStep));
  const Vec3 outwards = normalized(trefoil(along) * Vec3{0.35f, 0.35f, 2.0f} + Vec3{0.0f, 0.0f, 0.7f});
  const Vec3 a = normalized(cross(outwards, tangent)), b = cross(tangent, a);
  const float ridge = static_cast<float>(cosine_turns(2.0 * (around + 1.5 * along)));
  const float radius = 0.182f + 0.030f * ridge;
  return {trefoil(along) +
              radius * (static_cast<float>(cosine_turns(around)) * a + static_cast<float>(sine_turns(around)) * b),
          {}};
}

void add_knot(Pieces& pieces, Vec3 centre, float size) {
  const auto shape = [=](float u, float v) {
    constexpr double kStep = 1e-3;
    const Vec3 du = on_knot(u + kStep, v).position - on_knot(u - kStep, v).position;
    const Vec3 dv = on_knot(u, v + kStep).position - on_knot(u, v - kStep).position;
    return SurfacePoint{centre + size * on_knot(u, v).position, normalized(cross(du, dv))};
  };
  pieces.patch(shape, 0.12f, kBronze, 6.5 * kFinest);
}

void add_plinth(Pieces& pieces) {
  const std::vector<ProfilePoint> steps[] = {{{1.25f, 0.0f}, {1.25f, 0.06f}, {1.25f, 0.12f}},
                                             {{1.00f, 0.12f}, {1.00f, 0.18f}, {1.00f, 0.24f}},
                                             {{0.42f, 0.24f}, {0.36f, 0.34f}, {0.34f, 0.60f}, {0.40f, 0.84f}}};
  for (const auto& step : steps) {
    add_turned(pieces, {}, step, kPlinth, kFine);
    add_disc(pieces, {0.0f, step.back().height, 0.0f}, {0.0f, 1.0f, 0.0f}, step.back().radius, kPlinth, kCurved);
  }
}

/// Posts in a circle, and a rope that sags from post to post.
void add_barrier(Pieces& pieces) {
  constexpr int kPosts = 8;
  constexpr float kRadius = 1.75f, kTop = 0.92f;
  const std::vector<ProfilePoint> post = {{0.15f, 0.0f},   {0.14f, 0.02f},  {0.03f, 0.06f},  {0.022f, 0.15f},
                                          {0.022f, 0.90f}, {0.034f, 0.93f}, {0.030f, 0.97f}, {0.002f, 1.0f}};
  const auto corner = [](int i) { return Placement::at({}, (i + 0.5) / kPosts).point({kRadius, kTop, 0.0f}); };
  for (int i = 0; i < kPosts; ++i) {
    const Vec3 from = corner(i), to = corner(i + 1);
    add_turned(pieces, Placement::at({from.x, 0.0f, from.z}), post, kBrass, kFine);
    std::vector<TubePoint> rope;
    for (int k = 0; k <= 4; ++k) {
      const float t = static_cast<float>(k) / 4.0f;
      rope.push_back({from + t * (to - from) + Vec3{0.0f, -0.9f * t * (1.0f - t), 0.0f}, 0.022f});
    }
    add_tube(pieces, rope, kRope, kFinest);
  }
}

void add_bench(Pieces& pieces, const Placement& place) {
  for (const float x : {-0.62f, 0.62f}) {
    for (const float z : {-0.17f, 0.17f}) {
      add_box(pieces, place, {x - 0.03f, 0.0f, z - 0.03f}, {x + 0.03f, 0.38f, z + 0.03f}, kBrass, kFlat);
    }
  }
  add_cushion(pieces, place, {0.0f, 0.43f, 0.0f}, {0.75f, 0.06f, 0.25f}, kLeather, kCurved);
}

void add_pedestal(Pieces& pieces, const Placement& place) {
  add_box(pieces, place, {-0.30f, 0.0f, -0.30f}, {0.30f, 0.10f, 0.30f}, kMarble, kFlat);
  add_box(pieces, place, {-0.24f, 0.10f, -0.24f}, {0.24f, 1.02f, 0.24f}, kMarble, kFlat);
  add_box(pieces, place, {-0.29f, 1.02f, -0.29f}, {0.29f, 1.10f, 0.29f}, kMarble, kFlat);
}

}  // namespace

void add_exhibits(Pieces& pieces) {
  add_plinth(pieces);
  add_knot(pieces, {0.0f, 1.98f, 0.0f}, 1.02f);
  add_barrier(pieces);
  add_bench(pieces, Placement::at({0.0f, 0.0f, -4.4f}));
  add_bench(pieces, Placement::at({0.0f, 0.0f, 4.4f}));

  const std::vector<ProfilePoint> vase = {{0.002f, 0.001f}, {0.09f, 0.001f}, {0.10f, 0.03f}, {0.21f, 0.22f},
                                          {0.19f, 0.42f},   {0.08f, 0.56f},  {0.08f, 0.62f}, {0.12f, 0.68f}};
  for (const float x : {-2.5f, 2.5f}) {
    const Placement far_end = Placement::at({x, 0.0f, -6.6f}), near_end = Placement::at({x, 0.0f, 6.6f});
    add_pedestal(pieces, far_end);
    add_pedestal(pieces, near_end);
    add_sphere(pieces, near_end.point({0.0f, 1.36f, 0.0f}), 0.26f, x < 0.0f ? kGlass : kChrome, kFine);
    if (x < 0.0f) add_turned(pieces, far_end.inner({0.0f, 1.10f, 0.0f}), vase, kBlue, kFine);
    if (x > 0.0f) add_sphere(pieces, far_end.point({0.0f, 1.36f, 0.0f}), 0.26f, kGlass, kFine);
  }
}

}  // namespace raywalk::museum
