// Tubes, rings and slabs.
#include "scenes/common/links.h"

#include <algorithm>

#include "scenes/common/exact_math.h"
#include "scenes/common/solids.h"

namespace raywalk {
namespace {

/// Position, radius and their derivatives over the curve's parameter.
struct OnCurve {
  TubePoint point, slope;
};

TubePoint sum(const TubePoint& a, float s, const TubePoint& b) {
  return {a.at + s * b.at, a.radius + s * b.radius};
}

/// Uniform Catmull-Rom, its ends continued straight; v in [0, 1].
OnCurve on_curve(const std::vector<TubePoint>& points, float v) {
  const size_t segments = points.size() - 1;
  const float t = v * static_cast<float>(segments);
  const size_t i = std::min(static_cast<size_t>(t), segments - 1);
  const float u = t - static_cast<float>(i);
  const TubePoint &b = points[i], &c = points[i + 1];
  const TubePoint along = sum(c, -1.0f, b);
  const TubePoint in = i > 0 ? sum(c, -1.0f, points[i - 1]) : sum(along, 1.0f, along);
  const TubePoint out = i + 2 <= segments ? sum(points[i + 2], -1.0f, b) : sum(along, 1.0f, along);
  // Hermite form: half of `in` and `out` are the tangents at b and c.
  const float u2 = u * u, u3 = u2 * u;
  TubePoint at = sum(b, 3.0f * u2 - 2.0f * u3, along);
  at = sum(sum(at, 0.5f * (u3 - 2.0f * u2 + u), in), 0.5f * (u3 - u2), out);
  TubePoint slope = {6.0f * (u - u2) * along.at, 6.0f * (u - u2) * along.radius};
  slope = sum(sum(slope, 0.5f * (3.0f * u2 - 4.0f * u + 1.0f), in), 0.5f * (3.0f * u2 - 2.0f * u), out);
  return {at, slope};
}

/// The coordinate axis that the curve keeps furthest away from.
Vec3 reference_for(const std::vector<TubePoint>& points) {
  const Vec3 axes[] = {{0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f}};
  const auto closest = [&](Vec3 axis) {
    float most = 0.0f;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
      most = larger(most, magnitude(dot(axis, normalized(points[i + 1].at - points[i].at))));
    }
    return most;
  };
  return *std::min_element(std::begin(axes), std::end(axes), [&](Vec3 a, Vec3 b) { return closest(a) < closest(b); });
}

}  // namespace

Across across(Vec3 axis) {
  const Vec3 other = magnitude(axis.y) < 0.9f ? Vec3{0.0f, 1.0f, 0.0f} : Vec3{1.0f, 0.0f, 0.0f};
  const Vec3 first = normalized(cross(other, axis));
  return {first, cross(axis, first)};
}

void add_tube(Pieces& pieces, const std::vector<TubePoint>& points, u32 material, double density) {
  const Vec3 reference = reference_for(points);
  float along = 0.0f, widest = 0.0f;
  for (size_t i = 0; i < points.size(); ++i) {
    widest = larger(widest, points[i].radius);
    if (i > 0) along += length(points[i].at - points[i - 1].at) + magnitude(points[i].radius - points[i - 1].radius);
  }
  const float around = static_cast<float>(kTau) * widest;
  const auto shape = [=](float u, float v) {
    const OnCurve on = on_curve(points, v);
    const float speed = length(on.slope.at);
    const Vec3 tangent = on.slope.at * (1.0f / speed);
    const Vec3 a = normalized(cross(reference, tangent)), b = cross(tangent, a);
    const Vec3 out = static_cast<float>(cosine_turns(u)) * a + static_cast<float>(sine_turns(u)) * b;
    return SurfacePoint{on.point.at + on.point.radius * out, normalized(out - (on.slope.radius / speed) * tangent)};
  };
  // A thin tube needs corners around more than it needs rows along.
  const u64 segments = points.size() - 1;
  const float round = 8.0f / (3.0f * static_cast<float>(segments));
  pieces.patch(shape, larger(around / along, round), material, density * around * along, 8 + 4 * segments);
}

void add_rod(Pieces& pieces, Vec3 from, Vec3 to, float radius, u32 material, double density) {
  add_tube(pieces, {{from, radius}, {to, radius}}, material, density);
  const Vec3 axis = normalized(to - from);
  add_disc(pieces, to, axis, radius, material, density);
  add_disc(pieces, from, -axis, radius, material, density);
}

void add_ring(Pieces& pieces, Vec3 centre, Vec3 axis, float radius, float thickness, u32 material, double density) {
  const Across plane = across(axis);
  const auto shape = [=](float u, float v) {
    const Vec3 out =
        static_cast<float>(cosine_turns(v)) * plane.first + static_cast<float>(sine_turns(v)) * plane.second;
    const Vec3 normal = static_cast<float>(cosine_turns(u)) * out - static_cast<float>(sine_turns(u)) * axis;
    return SurfacePoint{centre + radius * out + thickness * normal, normal};
  };
  const float around = static_cast<float>(kTau) * thickness, along = static_cast<float>(kTau) * radius;
  pieces.patch(shape, larger(around / along, 0.3f), material, density * around * along, 48);
}

void add_slab(Pieces& pieces, Vec3 centre, Vec3 half_x, Vec3 half_y, Vec3 half_z, u32 material, double density) {
  const auto pair = [&](Vec3 x, Vec3 y, Vec3 z) {
    add_quad(pieces, centre + z - x - y, 2.0f * x, 2.0f * y, material, density);
    add_quad(pieces, centre - z - x - y, 2.0f * y, 2.0f * x, material, density);
  };
  pair(half_x, half_y, half_z);
  pair(half_y, half_z, half_x);
  pair(half_z, half_x, half_y);
}

void add_disc(Pieces& pieces, Vec3 centre, Vec3 axis, float radius, u32 material, double density) {
  const Across plane = across(axis);
  const auto shape = [=](float u, float v) {
    const float r = radius * larger(1.0f - v, 1e-3f);
    return SurfacePoint{centre + r * (static_cast<float>(cosine_turns(u)) * plane.first +
                                      static_cast<float>(sine_turns(u)) * plane.second),
                        axis};
  };
  // Turning left seen from outside: around first, inwards second.
  pieces.patch(shape, 6.0f, material, density * 0.5 * kTau * radius * radius, 8);
}

}  // namespace raywalk
