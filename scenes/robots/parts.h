// The parts of the robots' city and what they agree on. A robot is about 12 units tall, y up; the street is y = 0 and
// runs along z.
#pragma once
#include "scenes/common/exact_math.h"
#include "scenes/common/links.h"
#include "scenes/common/solids.h"
#include "scenes/robots/materials.h"

namespace raywalk::robots {

constexpr float kSideX = 164.15f, kEndZ = 342.7f, kTower = 536.0f;  // half width, half length, height of the city
constexpr float kStreetX = 34.0f, kFacadeX = 52.0f;                 // kerb, and where the buildings start
constexpr float kKerb = 0.5f;

// Shares of triangles: buildings get the fewest possible, robots nearly all.
constexpr double kFlat = 1e-5, kPlain = 0.3, kSmooth = 6.0, kFine = 20.0;

/// A coordinate system that is moved and turned joint by joint.
struct Joint {
  Vec3 origin{};
  Vec3 x{1.0f, 0.0f, 0.0f}, y{0.0f, 1.0f, 0.0f}, z{0.0f, 0.0f, 1.0f};

  Vec3 direction(Vec3 v) const { return v.x * x + v.y * y + v.z * z; }
  Vec3 point(Vec3 p) const { return origin + direction(p); }
  Joint moved(Vec3 by) const { return {point(by), x, y, z}; }
  /// Around the own x axis (z turns towards -y: forwards and down), y axis (z turns towards x) or z axis (x turns
  /// towards y).
  Joint pitched(double turns) const;
  Joint yawed(double turns) const;
  Joint rolled(double turns) const;
};

void add_city(Pieces& pieces);
/// Robots in the street and on the square.
void add_robots(Pieces& pieces);

/// How a robot stands: turns of its joints, 0 upright.
struct Pose {
  double stride;               // of the legs against each other
  double left_arm, right_arm;  // raised forwards
  double left_elbow, right_elbow;
  double look;  // of the head to its left
};
/// On two legs, facing +z of `feet`, whose origin is on the ground.
void add_biped(Pieces& pieces, const Joint& feet, float size, u32 paint, u32 second_paint, const Pose& pose);
/// On six legs, low; `phase` is where its gait is, in turns.
void add_crawler(Pieces& pieces, const Joint& feet, float size, u32 paint, double phase);

/// A ball with flattened sides in any direction.
void add_pod(Pieces& pieces, const Joint& joint, Vec3 centre, Vec3 half, u32 material, double density);
/// A box in a joint's coordinates.
void add_block(Pieces& pieces, const Joint& joint, Vec3 lo, Vec3 hi, u32 material);

}  // namespace raywalk::robots
