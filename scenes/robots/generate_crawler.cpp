// The robot on six legs: a flat body with a turning eye.
#include "scenes/robots/parts.h"

namespace raywalk::robots {
namespace {

void add_leg(Pieces& pieces, const Joint& hip, float size, u32 paint, double lift) {
  // Out and up to the knee, then down to the ground.
  const Joint upper = hip.pitched(-0.10 - lift);
  const Vec3 knee = upper.point({0.0f, 0.0f, 1.7f * size});
  const Vec3 foot = Vec3{0.0f, 0.0f, 0.0f} + hip.point({0.0f, 0.0f, 2.6f * size});
  const Vec3 ground = {foot.x, lift > 0.02 ? 0.35f * size : 0.0f, foot.z};
  add_sphere(pieces, hip.origin, 0.36f * size, kSteel, kSmooth);
  const Vec3 along = knee - hip.origin, down = ground - knee;
  add_tube(pieces,
           {{hip.origin, 0.16f * size},
            {hip.origin + 0.3f * along, 0.30f * size},
            {hip.origin + 0.7f * along, 0.26f * size},
            {knee, 0.12f * size}},
           paint, kSmooth);
  add_rod(pieces, knee - 0.3f * size * hip.x, knee + 0.3f * size * hip.x, 0.24f * size, kChrome, kSmooth);
  add_tube(pieces,
           {{knee, 0.16f * size},
            {knee + 0.25f * down, 0.24f * size},
            {knee + 0.75f * down, 0.12f * size},
            {ground, 0.02f * size}},
           kSteel, kSmooth);
}

}  // namespace

void add_crawler(Pieces& pieces, const Joint& feet, float size, u32 paint, double phase) {
  const Joint body = feet.moved({0.0f, 1.35f * size, 0.0f});
  add_pod(pieces, body, {}, size * Vec3{1.15f, 0.50f, 1.85f}, paint, kSmooth);
  add_pod(pieces, body, size * Vec3{0.0f, 0.34f, -0.45f}, size * Vec3{0.80f, 0.38f, 1.05f}, kSteel, kSmooth);
  for (int i = 0; i < 5; ++i) {
    add_ring(pieces, body.point(size * Vec3{0.0f, 0.38f, -1.15f + 0.35f * static_cast<float>(i)}), body.z, 0.62f * size,
             0.07f * size, kRubber, kSmooth);
  }
  const Joint eye = body.moved(size * Vec3{0.0f, 0.75f, 1.15f}).yawed(0.06);
  add_rod(pieces, eye.point(size * Vec3{0.0f, -0.5f, 0.0f}), eye.origin, 0.14f * size, kSteel, kSmooth);
  add_sphere(pieces, eye.point(size * Vec3{0.0f, 0.25f, 0.0f}), 0.42f * size, paint, kSmooth);
  add_ring(pieces, eye.point(size * Vec3{0.0f, 0.25f, 0.34f}), eye.z, 0.24f * size, 0.08f * size, kChrome, kSmooth);
  add_sphere(pieces, eye.point(size * Vec3{0.0f, 0.25f, 0.30f}), 0.20f * size, kLamp, kSmooth);
  for (const float x : {-0.55f, 0.55f}) {
    add_rod(pieces, body.point(size * Vec3{x, 0.3f, -1.6f}), body.point(size * Vec3{1.5f * x, 2.2f, -2.3f}),
            0.035f * size, kSteel, kSmooth);
  }
  for (int i = 0; i < 6; ++i) {
    const float side = i % 2 ? -1.0f : 1.0f;
    const float z = 1.15f * static_cast<float>(i / 2 - 1);
    const double lift = larger(0.0f, static_cast<float>(sine_turns(phase + 0.5 * i + 0.17 * (i / 2)))) * 0.05;
    const Joint hip = body.moved(size * Vec3{1.0f * side, 0.0f, z}).yawed(0.25 * side - 0.05 * side * (i / 2 - 1));
    add_leg(pieces, hip, size, paint, lift);
  }
}

}  // namespace raywalk::robots
