// Splines of positions and rotations: through their keys, even where they should be, and what tension does.
#include "server/scene/kochanek_bartels.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

namespace raywalk::test {
namespace {

PositionSpline on_x(std::vector<std::pair<double, double>> keys, double tension = 0.0, double continuity = 0.0,
                    double bias = 0.0) {
  std::vector<SplineKey<glm::dvec3>> all;
  for (const auto& [time, x] : keys) all.push_back({time, {x, 0, 0}, tension, continuity, bias});
  return PositionSpline(all);
}

glm::dquat around_y(double angle_deg) {
  return glm::angleAxis(glm::radians(angle_deg), glm::dvec3(0, 1, 0));
}

RotationSpline turning(std::vector<std::pair<double, double>> keys) {
  std::vector<SplineKey<glm::dquat>> all;
  for (const auto& [time, angle_deg] : keys) all.push_back({time, around_y(angle_deg)});
  return RotationSpline(all);
}

double speed(const PositionSpline& spline, double time) {
  return (spline.at(time + 1e-6).x - spline.at(time - 1e-6).x) / 2e-6;
}

TEST(KochanekBartels, even_keys_are_a_straight_walk_that_stands_at_its_ends) {
  const PositionSpline spline = on_x({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}});
  for (const double t : {1.0, 1.25, 1.9, 2.0, 2.7, 3.0}) EXPECT_NEAR(spline.at(t).x, t, 1e-12);
  EXPECT_EQ(spline.at(-5).x, 1.0);
  EXPECT_EQ(spline.at(0.5).x, 1.0);
  EXPECT_EQ(spline.at(3.5).x, 3.0);
  EXPECT_EQ(spline.at(99).x, 3.0);
  EXPECT_EQ(spline.at(std::numeric_limits<double>::quiet_NaN()).x, 1.0);
}

TEST(KochanekBartels, four_keys_by_hand) {
  // D = 2, the neighbours 1 and 3 away: out = (1 + 2) / 2, in = (2 + 3) / 2, at the middle 1 + (out - in) / 8 + D / 2.
  EXPECT_NEAR(on_x({{0, 0}, {1, 1}, {2, 3}, {3, 6}}).at(1.5).x, 2.0 + (1.5 - 2.5) / 8.0, 1e-12);
}

TEST(KochanekBartels, tension_stops_continuity_breaks_and_bias_leans) {
  const std::vector<std::pair<double, double>> keys = {{0, 0}, {1, 1}, {2, 2}, {3, 4}, {4, 4}, {5, 4}};
  EXPECT_NEAR(speed(on_x(keys), 2.0), 1.5, 1e-4);
  EXPECT_NEAR(speed(on_x(keys, 1.0), 2.0), 0.0, 1e-4);
  // Continuity -1: each segment goes straight to its end.
  EXPECT_NEAR(on_x(keys, 0.0, -1.0).at(1.25).x, 1.25, 1e-12);
  EXPECT_NEAR(on_x(keys, 0.0, -1.0).at(2.25).x, 2.5, 1e-12);
  EXPECT_NEAR(speed(on_x(keys, 0.0, 0.0, 1.0), 2.0), 1.0, 1e-4);
  EXPECT_NEAR(speed(on_x(keys, 0.0, 0.0, -1.0), 2.0), 2.0, 1e-4);
}

TEST(KochanekBartels, uneven_times_keep_the_speed_where_segments_meet) {
  const PositionSpline spline = on_x({{0, 0}, {1, 1}, {5, 2}, {6, 9}, {7, 9}});
  const double before = (spline.at(5.0).x - spline.at(5.0 - 1e-6).x) / 1e-6;
  const double behind = (spline.at(5.0 + 1e-6).x - spline.at(5.0).x) / 1e-6;
  EXPECT_NEAR(before, behind, 1e-4);
}

TEST(KochanekBartels, keys_at_one_time_jump) {
  const PositionSpline spline = on_x({{0, 0}, {0, 0}, {1, 1}, {1, 5}, {2, 6}, {2, 6}});
  EXPECT_LT(spline.at(0.999).x, 1.01);
  EXPECT_EQ(spline.at(1.0).x, 5.0);
  EXPECT_EQ(spline.at(2.0).x, 6.0);
}

TEST(KochanekBartels, rotations_turn_evenly_and_the_shorter_way) {
  const RotationSpline spline = turning({{0, 0}, {1, 30}, {2, 60}, {3, 90}, {4, 120}});
  for (const double t : {1.0, 1.25, 2.0, 2.6, 3.0}) {
    EXPECT_NEAR(std::abs(glm::dot(spline.at(t), around_y(30.0 * t))), 1.0, 1e-12) << t;
  }
  const RotationSpline far = turning({{0, 0}, {0, 0}, {1, 350}, {1, 350}});
  EXPECT_NEAR(std::abs(glm::dot(far.at(0.5), around_y(-5))), 1.0, 1e-12);
}

TEST(KochanekBartels, opposite_rotations_stay_finite) {
  const RotationSpline spline = turning({{0, 0}, {1, 0}, {2, 180}, {3, 360}, {4, 360}});
  for (double t = 1.0; t <= 3.0; t += 0.125) EXPECT_NEAR(glm::length(spline.at(t)), 1.0, 1e-9) << t;
}

TEST(KochanekBartels, still_and_bad_keys) {
  EXPECT_EQ(PositionSpline::still({1, 2, 3}).at(17), glm::dvec3(1, 2, 3));
  EXPECT_THROW(on_x({{0, 0}, {1, 1}, {2, 2}}), std::invalid_argument);
  EXPECT_THROW(on_x({{0, 0}, {1, 1}, {0.5, 2}, {3, 3}}), std::invalid_argument);
}

}  // namespace
}  // namespace raywalk::test
