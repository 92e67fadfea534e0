// Splitting to a number of triangles: exact, without cracks, without changing shape.
#include "server/scene/split.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "scenes/generator.h"
#include "server/scene/sinks.h"

namespace raywalk::test {
namespace {

using Point = std::tuple<float, float, float>;

Point point_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// How many triangles each edge has, by the positions of its ends.
std::map<std::pair<Point, Point>, u32> edges_of(const Scene& scene) {
  std::map<std::pair<Point, Point>, u32> edges;
  const auto add = [&](u32 a, u32 b) {
    const Point p = point_of(scene.positions[a]), q = point_of(scene.positions[b]);
    ++edges[std::minmax(p, q)];
  };
  for (const TriangleIndices& t : scene.triangles) {
    add(t.a, t.b);
    add(t.b, t.c);
    add(t.c, t.a);
  }
  return edges;
}

double area_of(const Scene& scene) {
  double area = 0;
  for (const TriangleIndices& t : scene.triangles) {
    area +=
        0.5 * length(cross(scene.positions[t.b] - scene.positions[t.a], scene.positions[t.c] - scene.positions[t.a]));
  }
  return area;
}

Scene ball() {
  Scene scene;
  SceneSink sink(scene);
  generate(*find_generator("organic"), 2000, sink);
  return scene;
}

Scene square() {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  scene.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  scene.triangles = {{0, 1, 2, 0}, {3, 4, 5, 1}};
  return scene;
}

TEST(Split, a_closed_surface_stays_closed_and_keeps_its_area) {
  Scene scene = ball();
  const double before = area_of(scene);
  const size_t triangles = scene.triangles.size();
  split_edges(scene, triangles + 4322);
  EXPECT_EQ(scene.triangles.size(), triangles + 4322);
  EXPECT_EQ(scene.normals.size(), scene.positions.size());
  for (const auto& [edge, count] : edges_of(scene)) ASSERT_EQ(count, 2u);
  EXPECT_NEAR(area_of(scene) / before, 1.0, 1e-6);
}

TEST(Split, vertices_of_one_place_are_one_corner) {
  Scene scene = square();
  split_edges(scene, 37);
  EXPECT_EQ(scene.triangles.size(), 37u);
  EXPECT_EQ(area_of(scene), 1.0);
  for (const auto& [edge, count] : edges_of(scene)) {
    const auto& [x0, y0, z0] = edge.first;
    const auto& [x1, y1, z1] = edge.second;
    const bool rim = (x0 == x1 && (x0 == 0 || x0 == 1)) || (y0 == y1 && (y0 == 0 || y0 == 1));
    EXPECT_EQ(count, rim ? 1u : 2u);
  }
  for (size_t i = 0; i < scene.positions.size(); ++i) {
    EXPECT_EQ(scene.texcoords[i].s, scene.positions[i].x);
    EXPECT_EQ(scene.texcoords[i].t, scene.positions[i].y);
  }
  double second = 0;
  for (const TriangleIndices& t : scene.triangles) {
    if (t.material == 1)
      second += 0.5 * cross(scene.positions[t.b] - scene.positions[t.a], scene.positions[t.c] - scene.positions[t.a]).z;
  }
  EXPECT_EQ(second, 0.5);
}

TEST(Split, triangles_without_area_stay_as_they_are) {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {9, 0, 0}};
  scene.triangles = {{0, 1, 2, 0}, {3, 4, 3, 0}};
  split_edges(scene, 9);
  EXPECT_EQ(scene.triangles[1].b, 4u);
  EXPECT_NEAR(area_of(scene), 0.5, 1e-6);
  for (size_t i = 5; i < scene.positions.size(); ++i) EXPECT_LE(scene.positions[i].x, 1.0f);
}

TEST(Split, triangles_whose_longest_edge_must_stay_stay_whole) {
  Scene scene = square();
  // Three thin triangles around one edge, longer than all of the square's.
  const u32 first = static_cast<u32>(scene.positions.size());
  for (const Vec3 p : {Vec3{0, 0, 5}, {9, 0, 5}, {4, 0.001f, 5}, {5, 0, 5.001f}, {5, -0.001f, 5}}) {
    scene.positions.push_back(p);
    scene.texcoords.push_back({0, 0});
  }
  for (const u32 tip : {2u, 3u, 4u}) scene.triangles.push_back({first, first + 1, first + tip, 2});
  split_edges(scene, 501);
  EXPECT_EQ(scene.triangles.size(), 501u);
  size_t thin = 0;
  for (const TriangleIndices& t : scene.triangles) {
    thin += t.material == 2;
    const Vec3 a = scene.positions[t.a], b = scene.positions[t.b], c = scene.positions[t.c];
    EXPECT_GT(length(cross(b - a, c - a)), 0.0f);
  }
  EXPECT_EQ(thin, 3u);
}

TEST(Split, is_the_same_each_time) {
  Scene a = ball(), b = ball();
  split_edges(a, a.triangles.size() + 500);
  split_edges(b, b.triangles.size() + 500);
  EXPECT_EQ(geometry_sha256(a), geometry_sha256(b));
}

TEST(Split, refuses_what_cannot_be) {
  Scene scene = ball();
  EXPECT_THROW(split_edges(scene, 10), std::invalid_argument);
  EXPECT_THROW(split_edges(scene, scene.triangles.size() + 1), std::invalid_argument);  // closed: two a step
  Scene none;
  EXPECT_THROW(split_edges(none, 1), std::invalid_argument);
  split_edges(none, 0);
  Scene flat;
  flat.positions = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  flat.triangles = {{0, 1, 2, 0}};
  EXPECT_THROW(split_edges(flat, 2), std::invalid_argument);
}

}  // namespace
}  // namespace raywalk::test
