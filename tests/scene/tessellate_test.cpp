// Curved primitives: exact counts, points on the surface, winding that agrees with the normals, no gaps.
#include "server/scene/tessellate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <vector>

namespace raywalk::test {
namespace {

using glm::dvec3;
using Triangle = std::array<SurfaceSample, 3>;
using Point = std::array<double, 3>;

struct Triangles {
  std::vector<Triangle> all;
  EmitTriangle emit = [this](const SurfaceSample& a, const SurfaceSample& b, const SurfaceSample& c) {
    all.push_back({a, b, c});
  };
};

Point point_of(const SurfaceSample& sample) {
  return {sample.position.x, sample.position.y, sample.position.z};
}

/// Unit normals on the side that the winding shows.
void expect_winding(const std::vector<Triangle>& triangles) {
  for (const Triangle& t : triangles) {
    const dvec3 turn = glm::cross(t[1].position - t[0].position, t[2].position - t[0].position);
    ASSERT_GT(glm::length(turn), 0.0);
    for (const SurfaceSample& sample : t) {
      EXPECT_NEAR(glm::length(sample.normal), 1.0, 1e-12);
      EXPECT_GT(glm::dot(turn, sample.normal), 0.0);
    }
  }
}

/// Edges that have no partner running the other way between bitwise equal points.
size_t open_edges(const std::vector<Triangle>& triangles) {
  std::map<std::pair<Point, Point>, int> balance;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const Point from = point_of(t[i]), to = point_of(t[(i + 1) % 3]);
      if (from < to) {
        ++balance[{from, to}];
      } else {
        --balance[{to, from}];
      }
    }
  }
  size_t open = 0;
  for (const auto& [edge, count] : balance) open += count != 0;
  return open;
}

/// The points at a height along an axis.
std::set<Point> rim(const std::vector<Triangle>& triangles, dvec3 centre, dvec3 axis) {
  std::set<Point> points;
  for (const Triangle& t : triangles) {
    for (const SurfaceSample& sample : t) {
      if (std::abs(glm::dot(sample.position - centre, glm::normalize(axis))) < 1e-9) points.insert(point_of(sample));
    }
  }
  return points;
}

const dvec3 kAxes[] = {{0, 0, 1}, {0, 0, -3}, {0, 1, 0}, {1, 0, 0}, {-2, 0, 0}, {1, 1, 1}, {1, -2, 0.3}, {3, 1, -7}};

TEST(Tessellate, cones_and_cylinders) {
  const dvec3 base{1, 2, 3};
  for (const dvec3 axis : kAxes) {
    Triangles cylinder, cone, pointed, upside_down;
    tessellate_cone(base, 2, base + axis, 2, 20, cylinder.emit);
    tessellate_cone(base, 2, base + axis, 0.5, 20, cone.emit);
    tessellate_cone(base, 2, base + axis, 0, 20, pointed.emit);
    tessellate_cone(base, 0, base + axis, 2, 20, upside_down.emit);
    EXPECT_EQ(cylinder.all.size(), 40u);
    EXPECT_EQ(cone.all.size(), 40u);
    EXPECT_EQ(pointed.all.size(), 20u);
    EXPECT_EQ(upside_down.all.size(), 20u);
    const dvec3 unit = glm::normalize(axis);
    for (const Triangles* t : {&cylinder, &cone, &pointed, &upside_down}) expect_winding(t->all);
    for (const Triangle& t : cone.all) {
      for (const SurfaceSample& sample : t) {
        const double along = glm::dot(sample.position - base, unit);
        const double away = glm::length(sample.position - base - along * unit);
        EXPECT_NEAR(away, 2 - 1.5 * along / glm::length(axis), 1e-8);
        // Perpendicular to the straight line through the point.
        const dvec3 radial = (sample.position - base - along * unit) / away;
        EXPECT_NEAR(glm::dot(sample.normal, axis - 1.5 * radial), 0.0, 1e-7);
        EXPECT_GT(glm::dot(sample.normal, radial), 0.0);
      }
    }
  }
}

TEST(Tessellate, a_negative_radius_turns_inwards) {
  Triangles cylinder, sphere;
  tessellate_cone({0, 0, 0}, -1, {0, 0, 2}, -1, 20, cylinder.emit);
  tessellate_sphere({0, 0, 0}, -1, 20, 10, sphere.emit);
  expect_winding(cylinder.all);
  expect_winding(sphere.all);
  for (const Triangle& t : cylinder.all) {
    EXPECT_LT(glm::dot(t[0].normal, dvec3(t[0].position.x, t[0].position.y, 0)), 0.0);
  }
  for (const Triangle& t : sphere.all) EXPECT_LT(glm::dot(t[0].normal, t[0].position), 0.0);
}

TEST(Tessellate, rings_and_discs) {
  const dvec3 centre{-1, 0.5, 2};
  for (const dvec3 axis : kAxes) {
    Triangles ring, disc;
    tessellate_ring(centre, axis, 0.5, 1.5, 20, ring.emit);
    tessellate_ring(centre, axis, 0, 1.5, 20, disc.emit);
    EXPECT_EQ(ring.all.size(), 40u);
    EXPECT_EQ(disc.all.size(), 20u);
    expect_winding(ring.all);
    expect_winding(disc.all);
    for (const Triangle& t : ring.all) {
      for (const SurfaceSample& sample : t) {
        const double away = glm::length(sample.position - centre);
        EXPECT_NEAR(std::abs(away - 1.0), 0.5, 1e-9);
        EXPECT_NEAR(glm::dot(sample.position - centre, axis), 0.0, 1e-7);
        EXPECT_GT(glm::dot(sample.normal, axis), 0.0);
      }
    }
  }
}

TEST(Tessellate, spheres_are_closed) {
  const dvec3 centre{3, -1, 0.1};
  for (const auto& [slices, stacks, count] :
       {std::array{20u, 10u, 360u}, std::array{15u, 14u, 390u}, std::array{3u, 2u, 6u}}) {
    Triangles sphere;
    tessellate_sphere(centre, 2.5, slices, stacks, sphere.emit);
    EXPECT_EQ(sphere.all.size(), count);
    EXPECT_EQ(open_edges(sphere.all), 0u);
    double volume = 0.0;
    for (const Triangle& t : sphere.all) {
      for (const SurfaceSample& sample : t) {
        EXPECT_NEAR(glm::length(sample.position - centre), 2.5, 1e-12);
        EXPECT_NEAR(glm::length(sample.position - centre - 2.5 * sample.normal), 0.0, 1e-12);
      }
      volume += glm::dot(t[0].position - centre, glm::cross(t[1].position - centre, t[2].position - centre)) / 6;
    }
    EXPECT_GT(volume, 0.0);
    if (slices > 3) {
      expect_winding(sphere.all);
      EXPECT_NEAR(volume, 4.0 / 3 * 3.14159 * 2.5 * 2.5 * 2.5, 4.0);
    }
  }
  Triangles none;
  tessellate_sphere(centre, 1, 20, 1, none.emit);
  tessellate_sphere(centre, 1, 0, 10, none.emit);
  EXPECT_TRUE(none.all.empty());
}

TEST(Tessellate, tori_are_closed) {
  const dvec3 centre{1, 1, -4};
  for (const dvec3 axis : kAxes) {
    Triangles torus;
    tessellate_torus(centre, axis, 1, 3, 20, 20, torus.emit);
    EXPECT_EQ(torus.all.size(), 800u);
    EXPECT_EQ(open_edges(torus.all), 0u);
    expect_winding(torus.all);
    const dvec3 unit = glm::normalize(axis);
    for (const Triangle& t : torus.all) {
      for (const SurfaceSample& sample : t) {
        const double along = glm::dot(sample.position - centre, unit);
        const dvec3 radial = glm::normalize(sample.position - centre - along * unit);
        EXPECT_NEAR(glm::length(sample.position - centre - 2.0 * radial), 1.0, 1e-8);
      }
    }
  }
}

TEST(Tessellate, equal_rims_on_one_axis_meet_exactly) {
  for (const dvec3 axis : kAxes) {
    const dvec3 low{0.1, 0.2, 0.3}, middle = low + 1.7 * axis, high = low + 2.9 * axis;
    Triangles lower, upper, flipped, ring, torus;
    tessellate_cone(low, 1, middle, 2, 20, lower.emit);
    tessellate_cone(middle, 2, high, 1, 20, upper.emit);
    tessellate_cone(high, 1, middle, 2, 20, flipped.emit);  // the same from the other end
    tessellate_ring(middle, -axis, 1, 2, 20, ring.emit);
    const std::set<Point> expected = rim(lower.all, middle, axis);
    EXPECT_EQ(expected.size(), 20u);
    EXPECT_EQ(rim(upper.all, middle, axis), expected);
    EXPECT_EQ(rim(flipped.all, middle, axis), expected);
    size_t shared = 0;
    for (const Point& point : rim(ring.all, middle, axis)) shared += expected.contains(point);
    EXPECT_EQ(shared, 20u);
    // A closed can: one side and two lids.
    Triangles can;
    tessellate_cone(low, 1, high, 1, 15, can.emit);
    tessellate_ring(high, axis, 0, 1, 15, can.emit);
    tessellate_ring(low, -axis, 0, 1, 15, can.emit);
    EXPECT_EQ(open_edges(can.all), 0u);
  }
}

TEST(Tessellate, degenerate_primitives_stay_finite) {
  Triangles flat;
  tessellate_cone({1, 1, 1}, 2, {1, 1, 1}, 1, 20, flat.emit);
  tessellate_cone({1, 1, 1}, 0, {1, 1, 1}, 0, 20, flat.emit);
  tessellate_ring({0, 0, 0}, {0, 0, 0}, 0, 1, 20, flat.emit);
  tessellate_torus({0, 0, 0}, {0, 0, 0}, 1, 1, 20, 20, flat.emit);
  EXPECT_EQ(flat.all.size(), 40u + 20 + 20 + 800);
  for (const Triangle& t : flat.all) {
    for (const SurfaceSample& sample : t) {
      EXPECT_TRUE(std::isfinite(glm::length(sample.position)));
      EXPECT_NEAR(glm::length(sample.normal), 1.0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace raywalk::test
