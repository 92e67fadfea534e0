// Boxes, turned shapes, balls and cushions.
#include "scenes/common/solids.h"

#include <algorithm>

#include "scenes/common/catmull_rom.h"
#include "scenes/common/exact_math.h"

namespace raywalk {
namespace {

/// On the smooth curve through the profile, v in [0, 1].
ProfilePoint on_profile(const std::vector<ProfilePoint>& profile, float v) {
  const size_t segments = profile.size() - 1;
  const float t = v * static_cast<float>(segments);
  const size_t i = std::min(static_cast<size_t>(t), segments - 1);
  const float u = t - static_cast<float>(i);
  const auto blend = [&](auto member) {
    return catmull_rom([&](size_t k) { return profile[k].*member; }, profile.size(), i, u);
  };
  return {blend(&ProfilePoint::radius), blend(&ProfilePoint::height)};
}

float profile_length(const std::vector<ProfilePoint>& profile) {
  float sum = 0.0f;
  for (size_t i = 0; i + 1 < profile.size(); ++i) {
    const float dr = profile[i + 1].radius - profile[i].radius, dh = profile[i + 1].height - profile[i].height;
    sum += square_root(dr * dr + dh * dh);
  }
  return sum;
}

}  // namespace

Placement Placement::at(Vec3 origin, double turns) {
  return {origin, static_cast<float>(cosine_turns(turns)), static_cast<float>(sine_turns(turns))};
}

Placement Placement::inner(Vec3 inner_origin, double turns) const {
  const Placement turn = at({}, turns);
  return {point(inner_origin), cosine * turn.cosine - sine * turn.sine, sine * turn.cosine + cosine * turn.sine};
}

void add_quad(Pieces& pieces, Vec3 corner, Vec3 edge_u, Vec3 edge_v, u32 material, double density) {
  const Vec3 normal = normalized(cross(edge_u, edge_v));
  const float lu = length(edge_u), lv = length(edge_v);
  pieces.patch(
      [=](float u, float v) {
        return SurfacePoint{corner + u * edge_u + v * edge_v, normal};
      },
      lu / lv, material, density * lu * lv);
}

void add_box(Pieces& pieces, const Placement& place, Vec3 lo, Vec3 hi, u32 material, double density) {
  const Vec3 size = hi - lo;
  const Vec3 x = place.direction({size.x, 0.0f, 0.0f});
  const Vec3 y = {0.0f, size.y, 0.0f};
  const Vec3 z = place.direction({0.0f, 0.0f, size.z});
  const Vec3 near_corner = place.point(lo), far_corner = place.point(hi);
  add_quad(pieces, near_corner, z, y, material, density);
  add_quad(pieces, near_corner, x, z, material, density);
  add_quad(pieces, near_corner, y, x, material, density);
  add_quad(pieces, far_corner, -y, -z, material, density);
  add_quad(pieces, far_corner, -z, -x, material, density);
  add_quad(pieces, far_corner, -x, -y, material, density);
}

void add_turned(Pieces& pieces, const Placement& place, const std::vector<ProfilePoint>& profile, u32 material,
                double density) {
  float widest = 0.0f;
  for (const ProfilePoint& p : profile) widest = larger(widest, p.radius);
  const float around = static_cast<float>(kTau) * widest, along = profile_length(profile);
  const auto shape = [=](float u, float v) {
    const float c = static_cast<float>(cosine_turns(u)), s = static_cast<float>(sine_turns(u));
    constexpr float kStep = 1e-3f;
    const ProfilePoint p = on_profile(profile, v);
    const ProfilePoint before = on_profile(profile, larger(v - kStep, 0.0f));
    const ProfilePoint after = on_profile(profile, smaller(v + kStep, 1.0f));
    const float dr = after.radius - before.radius, dh = after.height - before.height;
    return SurfacePoint{place.point({p.radius * c, p.height, -p.radius * s}),
                        place.direction(normalized({dh * c, -dr, -dh * s}))};
  };
  pieces.patch(shape, around / along, material, density * around * along);
}

void add_sphere(Pieces& pieces, Vec3 centre, float radius, u32 material, double density) {
  pieces.ball(
      [=](Vec3 d, float) {
        return SurfacePoint{centre + radius * d, d};
      },
      material, density * 2.0 * kTau * radius * radius);
}

void add_cushion(Pieces& pieces, const Placement& place, Vec3 centre, Vec3 half, u32 material, double density) {
  const auto shape = [=](Vec3 d, float) {
    const Vec3 d2 = d * d;
    const float fourth_root = square_root(square_root(dot(d2, d2)));
    const Vec3 unit = d * (1.0f / fourth_root);
    const Vec3 cube = unit * unit * unit;
    return SurfacePoint{place.point(centre + half * unit),
                        place.direction(normalized({cube.x / half.x, cube.y / half.y, cube.z / half.z}))};
  };
  pieces.ball(shape, material, density * 8.0 * (half.x * half.y + half.y * half.z + half.z * half.x));
}

}  // namespace raywalk
