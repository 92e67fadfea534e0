// Cones, rings, spheres and tori walked by angle.
#include "server/scene/tessellate.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <vector>

namespace raywalk {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr dvec3 kZ{0, 0, 1};

/// Cosine and sine of i / steps of a full turn, 0 <= i <= steps. The lower half mirrors the upper one bit by bit, so
/// that a circle walked the other way has the same points.
std::vector<dvec2> turn(u32 steps) {
  std::vector<dvec2> circle(steps + 1ull);
  for (u32 i = 0; i <= steps / 2; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / steps;
    circle[i] = i == 0 ? dvec2{1, 0} : 2 * i == steps ? dvec2{-1, 0} : dvec2{std::cos(angle), std::sin(angle)};
    circle[steps - i] = {circle[i].x, -circle[i].y};
  }
  return circle;
}

/// Right-handed: u, v, axis. u does not depend on the sign of the axis.
struct Frame {
  dvec3 u, v, axis;

  explicit Frame(dvec3 direction) {
    const double length = glm::length(direction);
    axis = length > 0.0 ? direction / length : kZ;
    // Axes that differ by rounding alone become one.
    constexpr double kGrid = 1 << 30;
    axis = glm::normalize(dvec3{std::round(axis.x * kGrid), std::round(axis.y * kGrid), std::round(axis.z * kGrid)});
    // The bound is far from the components of axes that people choose, where rounding would decide.
    const dvec3 start = std::abs(axis.x) < 0.65 ? dvec3{1, 0, 0} : dvec3{0, 1, 0};
    u = glm::normalize(start - axis * glm::dot(start, axis));
    v = glm::cross(axis, u);
  }
  dvec3 around(dvec2 angle) const { return angle.x * u + angle.y * v; }
};

/// Emits triangles as they are, or turned inside out.
class Facing {
 public:
  Facing(bool inwards, const EmitTriangle& emit) : inwards_(inwards), emit_(emit) {}
  void triangle(SurfaceSample a, SurfaceSample b, SurfaceSample c) const {
    if (!inwards_) return emit_(a, b, c);
    for (SurfaceSample* sample : {&a, &b, &c}) sample->normal = -sample->normal;
    emit_(a, c, b);
  }
  void quad(const SurfaceSample& a, const SurfaceSample& b, const SurfaceSample& c, const SurfaceSample& d) const {
    triangle(a, b, c);
    triangle(a, c, d);
  }

 private:
  bool inwards_;
  const EmitTriangle& emit_;
};

}  // namespace

void tessellate_cone(dvec3 base, double base_radius, dvec3 tip, double tip_radius, u32 slices,
                     const EmitTriangle& emit) {
  const Facing facing(base_radius < 0.0 || tip_radius < 0.0, emit);
  const double lower = std::abs(base_radius), upper = std::abs(tip_radius);
  const Frame frame(tip - base);
  const double height = glm::length(tip - base);
  const double slant = std::hypot(height, lower - upper);
  const double across = slant > 0.0 ? height / slant : 1.0, along = slant > 0.0 ? (lower - upper) / slant : 0.0;
  const auto sample = [&](dvec3 centre, double radius, dvec3 radial) {
    return SurfaceSample{centre + radius * radial, across * radial + along * frame.axis};
  };
  const std::vector<dvec2> angles = turn(slices), half_angles = turn(2 * slices);
  for (u32 i = 0; i < slices; ++i) {
    const dvec3 from = frame.around(angles[i]), to = frame.around(angles[i + 1]);
    const dvec3 middle = frame.around(half_angles[2 * i + 1]);  // for the normal of a point, which has none of its own
    if (upper == 0.0) {
      facing.triangle(sample(base, lower, from), sample(base, lower, to), sample(tip, upper, middle));
    } else if (lower == 0.0) {
      facing.triangle(sample(base, lower, middle), sample(tip, upper, to), sample(tip, upper, from));
    } else {
      facing.quad(sample(base, lower, from), sample(base, lower, to), sample(tip, upper, to), sample(tip, upper, from));
    }
  }
}

void tessellate_ring(dvec3 centre, dvec3 normal, double inner_radius, double outer_radius, u32 slices,
                     const EmitTriangle& emit) {
  const Facing facing(inner_radius < 0.0 || outer_radius < 0.0, emit);
  const double inner = std::abs(inner_radius), outer = std::abs(outer_radius);
  const Frame frame(normal);
  const auto sample = [&](double radius, dvec3 radial) { return SurfaceSample{centre + radius * radial, frame.axis}; };
  const std::vector<dvec2> angles = turn(slices);
  for (u32 i = 0; i < slices; ++i) {
    const dvec3 from = frame.around(angles[i]), to = frame.around(angles[i + 1]);
    if (inner == 0.0) {
      facing.triangle(sample(0.0, from), sample(outer, from), sample(outer, to));
    } else {
      facing.quad(sample(inner, from), sample(outer, from), sample(outer, to), sample(inner, to));
    }
  }
}

void tessellate_sphere(dvec3 centre, double radius, u32 slices, u32 stacks, const EmitTriangle& emit) {
  const Facing facing(radius < 0.0, emit);
  const std::vector<dvec2> angles = turn(slices);
  const std::vector<dvec2> latitudes = turn(2 * stacks);  // its first half, from the upper pole to the lower one
  const auto sample = [&](u32 slice, u32 stack) {
    const dvec2 angle = angles[slice], latitude = latitudes[stack];
    const dvec3 out{latitude.y * angle.x, latitude.y * angle.y, latitude.x};
    return SurfaceSample{centre + std::abs(radius) * out, out};
  };
  for (u32 stack = 0; stack < stacks; ++stack) {
    for (u32 slice = 0; slice < slices; ++slice) {
      const SurfaceSample upper = sample(slice, stack), lower_next = sample(slice + 1, stack + 1);
      if (stack + 1 < stacks) facing.triangle(upper, sample(slice, stack + 1), lower_next);
      if (stack > 0) facing.triangle(upper, lower_next, sample(slice + 1, stack));
    }
  }
}

void tessellate_torus(dvec3 centre, dvec3 normal, double inner_radius, double outer_radius, u32 slices, u32 stacks,
                      const EmitTriangle& emit) {
  const Facing facing(inner_radius < 0.0 || outer_radius < 0.0, emit);
  const double inner = std::abs(inner_radius), outer = std::abs(outer_radius);
  const double ring = 0.5 * (inner + outer), tube = 0.5 * (outer - inner);
  const Frame frame(normal);
  const std::vector<dvec2> angles = turn(slices), turns = turn(stacks);
  const auto sample = [&](u32 slice, u32 stack) {
    const dvec3 radial = frame.around(angles[slice]);
    const dvec3 out = turns[stack].x * radial + turns[stack].y * frame.axis;
    return SurfaceSample{centre + ring * radial + tube * out, out};
  };
  for (u32 slice = 0; slice < slices; ++slice) {
    for (u32 stack = 0; stack < stacks; ++stack) {
      facing.quad(sample(slice, stack), sample(slice + 1, stack), sample(slice + 1, stack + 1),
                  sample(slice, stack + 1));
    }
  }
}

}  // namespace raywalk
