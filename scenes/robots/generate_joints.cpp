// Joints, and what hangs on them.
#include "scenes/robots/parts.h"

namespace raywalk::robots {
namespace {

/// a turned towards b.
Vec3 turned(Vec3 a, Vec3 b, double turns) {
  return static_cast<float>(cosine_turns(turns)) * a + static_cast<float>(sine_turns(turns)) * b;
}

}  // namespace

Joint Joint::pitched(double turns) const {
  return {origin, x, turned(y, z, turns), turned(z, -y, turns)};
}

Joint Joint::yawed(double turns) const {
  return {origin, turned(x, -z, turns), y, turned(z, x, turns)};
}

Joint Joint::rolled(double turns) const {
  return {origin, turned(x, y, turns), turned(y, -x, turns), z};
}

void add_pod(Pieces& pieces, const Joint& joint, Vec3 centre, Vec3 half, u32 material, double density) {
  const auto shape = [=](Vec3 d, float) {
    const Vec3 d2 = d * d;
    const Vec3 unit = d * (1.0f / square_root(square_root(dot(d2, d2))));
    const Vec3 cube = unit * unit * unit;
    return SurfacePoint{joint.point(centre + half * unit),
                        joint.direction(normalized({cube.x / half.x, cube.y / half.y, cube.z / half.z}))};
  };
  pieces.ball(shape, material, density * 8.0 * (half.x * half.y + half.y * half.z + half.z * half.x));
}

void add_block(Pieces& pieces, const Joint& joint, Vec3 lo, Vec3 hi, u32 material) {
  const Vec3 half = 0.5f * (hi - lo);
  add_slab(pieces, joint.point(lo + half), half.x * joint.x, half.y * joint.y, half.z * joint.z, material, kPlain);
}

}  // namespace raywalk::robots
