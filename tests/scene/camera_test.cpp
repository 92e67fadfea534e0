// Camera paths, and that the walks of the shipped scenes keep clear of everything.
#include <gtest/gtest.h>

#include <algorithm>

#include "server/scene/catalog_files.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

void expect_near(Vec3 a, Vec3 b, float tolerance) {
  EXPECT_LT(length(a - b), tolerance) << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " "
                                      << b.z;
}

TEST(Orbit, closes_at_any_number_of_frames) {
  const CameraPath path{OrbitPath{{1, 2, 3}, 10.0f, 30.0f, 0.0f, 1.0f, 45.0f}, 400};
  for (const u32 n : {1u, 4u, 400u}) {
    expect_near(pose_at(path, 0, n).eye, {1.0f, 7.0f, 3.0f + 8.660254f}, 1e-4f);
  }
  expect_near(pose_at(path, 1, 4).eye, {1.0f + 8.660254f, 7.0f, 3.0f}, 1e-4f);
  expect_near(pose_at(path, 100, 400).eye, pose_at(path, 1, 4).eye, 1e-5f);
  EXPECT_THROW(pose_at(path, 4, 4), std::invalid_argument);
}

TEST(Spline, passes_through_its_ends_and_keys_at_even_speed) {
  const CameraPath path{
      SplinePath{{{{0, 0, 0}, {0, 0, -5}, 40.0f}, {{1, 0, 0}, {1, 0, -5}, 50.0f}, {{5, 3, 0}, {5, 0, -5}, 60.0f}}},
      400};
  EXPECT_EQ(pose_at(path, 0, 400).eye, (Vec3{0, 0, 0}));
  expect_near(pose_at(path, 399, 400).eye, {5, 3, 0}, 1e-5f);
  expect_near(pose_at(path, 0, 1).eye, {0, 0, 0}, 1e-6f);
  EXPECT_FLOAT_EQ(pose_at(path, 399, 400).vertical_fov_deg, 60.0f);
  float nearest = 1e9f, shortest = 1e9f, longest = 0.0f;
  for (u32 k = 0; k + 1 < 400; ++k) {
    const Vec3 a = pose_at(path, k, 400).eye, b = pose_at(path, k + 1, 400).eye;
    nearest = std::min(nearest, length(a - Vec3{1, 0, 0}));
    shortest = std::min(shortest, length(b - a));
    longest = std::max(longest, length(b - a));
  }
  EXPECT_LT(nearest, 0.01f);
  EXPECT_LT(longest / shortest, 1.6f);
  EXPECT_THROW(pose_at({SplinePath{{{{0, 0, 0}, {0, 0, 1}, 40.0f}}}, 400}, 0, 1), std::invalid_argument);
}

/// Distance from a point to a triangle (the nearest of face, edges and corners).
float distance(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 normal = normalized(cross(b - a, c - a));
  const auto side = [&](Vec3 s, Vec3 t) { return dot(cross(t - s, p - s), normal) >= 0.0f; };
  if (length(normal) > 0.5f && side(a, b) && side(b, c) && side(c, a)) return magnitude(dot(p - a, normal));
  const auto to_edge = [&](Vec3 s, Vec3 t) {
    const float l2 = dot(t - s, t - s);
    const float u = l2 > 0.0f ? std::clamp(dot(p - s, t - s) / l2, 0.0f, 1.0f) : 0.0f;
    return length(p - (s + u * (t - s)));
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

/// Smallest distance of any frame's eye to the scene. Steps between frames are shorter than the clearance asked for,
/// so a path that starts in the open never enters a solid.
void expect_clear(const char* name, u64 triangles, float clearance) {
  const Scene scene = load_scene(name, scenes_dir(), "no-data", triangles);
  std::vector<Vec3> eyes;
  for (u32 k = 0; k < 400; ++k) eyes.push_back(pose_at(scene.camera_path, k, 400).eye);
  std::vector<float> nearest(400, 1e9f);
  for (const TriangleIndices& t : scene.triangles) {
    const Vec3 a = scene.positions[t.a], b = scene.positions[t.b], c = scene.positions[t.c];
    Box box;
    box.add(a);
    box.add(b);
    box.add(c);
    for (u32 k = 0; k < 400; ++k) {
      const Vec3 gap = larger(larger(box.lo - eyes[k], eyes[k] - box.hi), Vec3{0, 0, 0});
      if (length(gap) < nearest[k]) nearest[k] = std::min(nearest[k], distance(eyes[k], a, b, c));
    }
  }
  for (u32 k = 0; k < 400; ++k) {
    ASSERT_GT(nearest[k], clearance) << name << " frame " << k << " at " << eyes[k].x << " " << eyes[k].y << " "
                                     << eyes[k].z;
    if (k == 0) continue;
    // The spheres that are free around two eyes in a row overlap: nothing lies between them.
    ASSERT_LT(length(eyes[k] - eyes[k - 1]), nearest[k] + nearest[k - 1]) << name << " frame " << k;
  }
}

TEST(Walk, room_keeps_clear_of_the_furniture) {
  expect_clear("room", 30'000, 0.25f);
}

TEST(Walk, room_stays_in_the_room) {
  const Scene scene = load_scene("room", scenes_dir(), "no-data", 30'000);
  for (u32 k = 0; k < 400; ++k) {
    const Vec3 eye = pose_at(scene.camera_path, k, 400).eye;
    EXPECT_TRUE(magnitude(eye.x) < 2.7f && magnitude(eye.z) < 2.2f && eye.y > 1.0f && eye.y < 2.2f) << k;
  }
}

TEST(Walk, city_keeps_clear_of_the_buildings) {
  expect_clear("city", 350'000, 1.0f);
}

TEST(Walk, museum_keeps_clear_of_the_exhibits) {
  expect_clear("museum", 14'380, 0.3f);
}

TEST(Walk, kitchen_keeps_clear_of_the_furniture) {
  expect_clear("kitchen", 110'559, 0.25f);
}

TEST(Walk, robots_keeps_clear_of_the_robots) {
  expect_clear("robots", 71'708, 1.0f);
}

TEST(Walk, theatre_keeps_clear_of_the_seats) {
  expect_clear("theatre", 53'832, 0.25f);
}

TEST(Walk, office_keeps_clear_of_the_furniture) {
  expect_clear("office", 36'310, 0.25f);
}

TEST(Walk, conference_keeps_clear_of_the_chairs) {
  expect_clear("conference", 298'866, 0.25f);
}

}  // namespace
}  // namespace raywalk::test
