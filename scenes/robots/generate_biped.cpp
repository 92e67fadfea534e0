// The robot on two legs: feet with toes, armoured links, a chest with its instruments, claws and a visor.
#include "scenes/robots/parts.h"

namespace raywalk::robots {
namespace {

constexpr float kThigh = 2.5f, kShin = 2.6f, kSole = 0.75f;  // lengths of the leg, and the ankle's height

struct Builder {
  Pieces& pieces;
  float size;
  u32 paint, second_paint;

  void ball(const Joint& j, Vec3 at, float radius, u32 material) const {
    add_sphere(pieces, j.point(size * at), size * radius, material, kSmooth);
  }
  void rod(const Joint& j, Vec3 from, Vec3 to, float radius, u32 material) const {
    add_rod(pieces, j.point(size * from), j.point(size * to), size * radius, material, kSmooth);
  }
  void ring(const Joint& j, Vec3 at, Vec3 axis, float radius, float thickness, u32 material) const {
    add_ring(pieces, j.point(size * at), j.direction(axis), size * radius, size * thickness, material, kSmooth);
  }
  void pod(const Joint& j, Vec3 centre, Vec3 half, u32 material) const {
    add_pod(pieces, j, size * centre, size * half, material, kSmooth);
  }
  void block(const Joint& j, Vec3 lo, Vec3 hi, u32 material) const {
    add_block(pieces, j, size * lo, size * hi, material);
  }
  /// A shell that swells between two joints, along the negative y axis.
  void shell(const Joint& j, float from, float to, float thin, float thick, u32 material) const {
    const float step = (to - from) / 6.0f;
    const float radii[] = {0.4f * thin, thin, 0.5f * (thin + thick), thick, thick, 0.8f * thick, 0.5f * thin};
    std::vector<TubePoint> points;
    for (int i = 0; i < 7; ++i) {
      points.push_back({j.point({0.0f, -size * (from + step * static_cast<float>(i)), 0.0f}), size * radii[i]});
    }
    add_tube(pieces, points, material, kSmooth);
  }

  /// Swings by `hip` and bends the knee by `knee`; the foot stays level.
  void leg(const Joint& pelvis, float side, double hip, double knee) const {
    const Joint upper = pelvis.moved({0.95f * size * side, 0.0f, 0.0f}).pitched(-hip);
    ball(upper, {}, 0.50f, kSteel);
    ring(upper, {0.30f * side, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, 0.46f, 0.10f, second_paint);
    rod(upper, {0.0f, 0.0f, 0.0f}, {0.0f, -kThigh, 0.0f}, 0.20f, kSteel);
    shell(upper, 0.35f, kThigh - 0.25f, 0.36f, 0.50f, paint);
    const Joint lower = upper.moved({0.0f, -kThigh * size, 0.0f}).pitched(knee);
    rod(lower, {-0.42f, 0.0f, 0.0f}, {0.42f, 0.0f, 0.0f}, 0.36f, kSteel);
    block(lower, {-0.22f, -0.30f, 0.22f}, {0.22f, 0.42f, 0.48f}, second_paint);
    rod(lower, {}, {0.0f, -kShin, 0.0f}, 0.17f, kSteel);
    rod(lower, {0.0f, -0.3f, -0.34f}, {0.0f, -kShin + 0.2f, -0.16f}, 0.07f, kChrome);
    shell(lower, 0.40f, kShin - 0.35f, 0.44f, 0.40f, paint);
    const Joint foot = lower.moved({0.0f, -kShin * size, 0.0f}).pitched(hip - knee);
    ball(foot, {}, 0.30f, kSteel);
    block(foot, {-0.48f, -kSole, -0.75f}, {0.48f, -0.32f, 0.55f}, paint);
    block(foot, {-0.40f, -0.32f, -0.45f}, {0.40f, -0.12f, 0.35f}, second_paint);
    for (const float x : {-0.33f, 0.0f, 0.33f}) {
      block(foot, {x - 0.13f, -kSole, 0.55f}, {x + 0.13f, -0.48f, 1.25f}, kRubber);
      rod(foot, {x - 0.13f, -0.52f, 0.58f}, {x + 0.13f, -0.52f, 0.58f}, 0.12f, kSteel);
    }
  }

  void claw(const Joint& wrist) const {
    rod(wrist, {}, {0.0f, -0.34f, 0.0f}, 0.26f, kSteel);
    for (int i = 0; i < 3; ++i) {
      const Joint finger = wrist.moved({0.0f, -0.30f * size, 0.0f}).yawed(i / 3.0).moved({0.0f, 0.0f, 0.20f * size});
      const Joint first = finger.pitched(-0.10), second = first.moved({0.0f, -0.55f * size, 0.0f}).pitched(0.17);
      block(first, {-0.10f, -0.58f, -0.09f}, {0.10f, 0.02f, 0.09f}, kSteel);
      rod(second, {-0.13f, 0.0f, 0.0f}, {0.13f, 0.0f, 0.0f}, 0.11f, kChrome);
      block(second, {-0.08f, -0.58f, -0.07f}, {0.08f, 0.0f, 0.07f}, kRubber);
    }
  }

  void arm(const Joint& chest, float side, double raise, double elbow) const {
    const Joint upper = chest.moved({1.72f * size * side, 1.05f * size, 0.0f}).rolled(0.035 * side).pitched(-raise);
    ball(upper, {}, 0.52f, kSteel);
    pod(upper, {0.12f * side, 0.22f, 0.0f}, {0.60f, 0.42f, 0.62f}, paint);
    rod(upper, {}, {0.0f, -1.9f, 0.0f}, 0.18f, kSteel);
    shell(upper, 0.45f, 1.65f, 0.30f, 0.36f, second_paint);
    const Joint lower = upper.moved({0.0f, -1.9f * size, 0.0f}).pitched(-elbow);
    ball(lower, {}, 0.36f, kSteel);
    ring(lower, {}, {1.0f, 0.0f, 0.0f}, 0.36f, 0.08f, kChrome);
    rod(lower, {}, {0.0f, -1.9f, 0.0f}, 0.16f, kSteel);
    shell(lower, 0.32f, 1.65f, 0.34f, 0.44f, paint);
    ring(lower, {0.0f, -1.62f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.34f, 0.09f, second_paint);
    claw(lower.moved({0.0f, -1.85f * size, 0.0f}));
  }

  void body(const Joint& chest) const {
    pod(chest, {0.0f, 0.62f, 0.0f}, {1.45f, 1.20f, 0.98f}, paint);
    pod(chest, {0.0f, 0.72f, 0.42f}, {0.95f, 0.70f, 0.66f}, second_paint);
    // Instruments on the chest, air slots below them, and the pack on the back.
    ring(chest, {-0.42f, 0.92f, 1.02f}, {0.0f, 0.0f, 1.0f}, 0.22f, 0.06f, kChrome);
    ball(chest, {-0.42f, 0.92f, 0.98f}, 0.17f, kLamp);
    block(chest, {0.08f, 0.74f, 0.96f}, {0.68f, 1.10f, 1.10f}, kVisor);
    for (int i = 0; i < 4; ++i) {
      const float y = 0.28f + 0.11f * static_cast<float>(i);
      block(chest, {-0.55f, y, 0.98f}, {0.55f, y + 0.05f, 1.09f}, kRubber);
    }
    block(chest, {-0.85f, 0.05f, -1.55f}, {0.85f, 1.55f, -0.80f}, kSteel);
    for (const float x : {-0.5f, 0.5f}) {
      rod(chest, {x, 0.15f, -1.60f}, {x, 1.95f, -1.60f}, 0.26f, second_paint);
      rod(chest, {x, -0.15f, -1.60f}, {x, 0.15f, -1.60f}, 0.17f, kChrome);
    }
    // Bellows of the waist.
    for (int i = 0; i < 4; ++i) {
      ring(chest, {0.0f, -0.62f - 0.20f * static_cast<float>(i), 0.0f}, {0.0f, 1.0f, 0.0f}, 0.50f, 0.13f, kRubber);
    }
  }

  void head(const Joint& neck) const {
    rod(neck, {0.0f, -0.35f, 0.0f}, {0.0f, 0.45f, 0.0f}, 0.26f, kSteel);
    ring(neck, {0.0f, 0.05f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.32f, 0.09f, kRubber);
    pod(neck, {0.0f, 1.02f, 0.0f}, {0.78f, 0.68f, 0.72f}, paint);
    pod(neck, {0.0f, 1.12f, 0.36f}, {0.66f, 0.26f, 0.44f}, kVisor);
    for (const float x : {-0.28f, 0.28f}) ball(neck, {x, 1.12f, 0.74f}, 0.12f, kLamp);
    block(neck, {-0.34f, 0.52f, 0.52f}, {0.34f, 0.74f, 0.76f}, kSteel);
    for (const float side : {-1.0f, 1.0f}) {
      rod(neck, {0.70f * side, 1.02f, 0.0f}, {0.94f * side, 1.02f, 0.0f}, 0.28f, second_paint);
    }
    rod(neck, {0.86f, 1.02f, 0.0f}, {0.86f, 2.35f, -0.15f}, 0.035f, kSteel);
    ball(neck, {0.86f, 2.42f, -0.16f}, 0.10f, kLamp);
  }
};

}  // namespace

void add_biped(Pieces& pieces, const Joint& feet, float size, u32 paint, u32 second_paint, const Pose& pose) {
  const Builder robot = {pieces, size, paint, second_paint};
  // One leg swings forwards, its knee bent; the other pushes off behind. The deeper one carries the pelvis.
  const double front = pose.stride, back = -0.6 * pose.stride;
  const double front_knee = 0.9 * pose.stride, back_knee = 0.5 * pose.stride;
  const auto reach = [](double hip, double knee) {
    return kThigh * static_cast<float>(cosine_turns(hip)) + kShin * static_cast<float>(cosine_turns(hip - knee)) +
           kSole;
  };
  const float height = larger(reach(front, front_knee), reach(back, back_knee));
  const Joint pelvis = feet.moved({0.0f, size * height, 0.0f});
  robot.pod(pelvis, {0.0f, 0.25f, 0.0f}, {0.92f, 0.46f, 0.62f}, second_paint);
  robot.leg(pelvis, 1.0f, front, front_knee);
  robot.leg(pelvis, -1.0f, back, back_knee);
  const Joint chest = pelvis.moved({0.0f, 1.75f * size, 0.0f}).pitched(0.25 * pose.stride).yawed(-0.3 * pose.stride);
  robot.body(chest);
  robot.arm(chest, 1.0f, pose.left_arm, pose.left_elbow);
  robot.arm(chest, -1.0f, pose.right_arm, pose.right_elbow);
  robot.head(chest.moved({0.0f, 2.05f * size, 0.0f}).yawed(pose.look));
}

}  // namespace raywalk::robots
