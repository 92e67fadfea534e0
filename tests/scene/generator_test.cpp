// Generators: exact counts, the same bits every time, sound geometry, streaming.
#include <gtest/gtest.h>

#include <map>

#include "scenes/generator.h"
#include "server/scene/catalog_files.h"
#include "server/scene/importer.h"
#include "server/scene/sinks.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

Scene generated(const char* name, u64 triangles) {
  Scene scene;
  SceneSink sink(scene);
  generate(*find_generator(name), triangles, sink);
  return scene;
}

class EachGenerator : public testing::TestWithParam<const Generator*> {};

TEST_P(EachGenerator, gives_exactly_what_is_asked_for) {
  const Generator& generator = *GetParam();
  const u64 least = generator.least_triangles;
  for (const u64 n : {least, least + 1, least + 2, least + 777, 2 * least + 1, u64{69451}, u64{100000}, u64{123457}}) {
    const Scene scene = generated(generator.name, n);
    ASSERT_EQ(scene.triangles.size(), n);
    ASSERT_EQ(scene.normals.size(), scene.positions.size());
    u64 bad = 0;
    for (const TriangleIndices& t : scene.triangles) bad += std::max({t.a, t.b, t.c}) >= scene.positions.size();
    EXPECT_EQ(bad, 0u);
    for (const Vec3& p : scene.positions) bad += !is_finite(p);
    for (const Vec3& m : scene.normals) bad += !(magnitude(length(m) - 1.0f) < 1e-3f);
    EXPECT_EQ(bad, 0u) << generator.name << " " << n;
  }
}

TEST_P(EachGenerator, gives_the_same_bits_again) {
  const u64 n = GetParam()->least_triangles + 12345;
  EXPECT_EQ(geometry_sha256(generated(GetParam()->name, n)), geometry_sha256(generated(GetParam()->name, n)));
}

TEST_P(EachGenerator, refuses_too_few_and_too_many) {
  CountingSink sink;
  EXPECT_THROW(generate(*GetParam(), GetParam()->least_triangles - 1, sink), std::invalid_argument);
  EXPECT_THROW(generate(*GetParam(), 5'000'000'000ull, sink), std::invalid_argument);
}

TEST_P(EachGenerator, streams_the_same_mesh_into_a_file) {
  const Folder folder;
  const u64 n = GetParam()->least_triangles + 4321;
  PlySink sink(folder.path() / "mesh.ply");
  generate(*GetParam(), n, sink);
  sink.finish();
  const Scene from_file = load_mesh(folder.path() / "mesh.ply");
  EXPECT_EQ(from_file.content_sha256, geometry_sha256(generated(GetParam()->name, n)));
}

INSTANTIATE_TEST_SUITE_P(, EachGenerator, testing::ValuesIn(generators().begin(), generators().end()),
                         [](const auto& each) { return each.param->name; });

TEST(Organic, is_closed_and_turns_outwards) {
  for (const u64 n : {80, 94, 4096, 20001, 69451}) {
    const Scene scene = generated("organic", n);
    // The odd triangle of an odd count is the last one and lies inside.
    const u64 shell = n / 2 * 2;
    std::map<std::pair<u32, u32>, int> edges;
    double volume = 0.0;
    for (u64 i = 0; i < shell; ++i) {
      const TriangleIndices& t = scene.triangles[i];
      for (const auto& edge : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) ++edges[edge];
      const Vec3 centre = {-0.0168f, 0.1f, -0.0015f};
      const Vec3 a = scene.positions[t.a] - centre, b = scene.positions[t.b] - centre,
                 c = scene.positions[t.c] - centre;
      volume += dot(a, cross(b, c)) / 6.0;
    }
    u64 open = 0;
    for (const auto& [edge, count] : edges) open += count != 1 || edges.count({edge.second, edge.first}) == 0;
    EXPECT_EQ(open, 0u) << n;
    EXPECT_EQ(edges.size(), 3 * shell);
    EXPECT_GT(volume, 0.0005);
    for (const TriangleIndices& t : std::span(scene.triangles).subspan(shell)) {
      EXPECT_LT(length(scene.positions[t.a] - Vec3{-0.0168f, 0.1f, -0.0015f}), 0.002f);
    }
  }
}

/// Share of triangles whose front is not the side of their normals.
double share_inside_out(const Scene& scene) {
  u64 against = 0;
  for (const TriangleIndices& t : scene.triangles) {
    const Vec3 a = scene.positions[t.a];
    const Vec3 flat = cross(scene.positions[t.b] - a, scene.positions[t.c] - a);
    against += dot(flat, scene.normals[t.a] + scene.normals[t.b] + scene.normals[t.c]) < 0.0f;
  }
  return static_cast<double>(against) / static_cast<double>(scene.triangles.size());
}

TEST(Normals, agree_with_the_triangles) {
  // Triangles over the creases between scales, and of noise finer than the tessellation, may differ.
  EXPECT_LT(share_inside_out(generated("organic", 200'000)), 0.002);
  EXPECT_LT(share_inside_out(generated("room", 120'000)), 0.002);
  EXPECT_LT(share_inside_out(generated("city", 350'000)), 0.002);
  EXPECT_LT(share_inside_out(generated("robots", 71'708)), 0.002);
  EXPECT_LT(share_inside_out(generated("buddha", 300'000)), 0.002);
  // So may those over the thin rims of posts and plates.
  EXPECT_LT(share_inside_out(generated("museum", 14'380)), 0.01);
  EXPECT_LT(share_inside_out(generated("kitchen", 110'559)), 0.01);
  EXPECT_LT(share_inside_out(generated("theatre", 53'832)), 0.002);
  EXPECT_LT(share_inside_out(generated("office", 36'310)), 0.002);
  EXPECT_LT(share_inside_out(generated("conference", 298'866)), 0.002);
  EXPECT_EQ(share_inside_out(generated("soup", 1000)), 0.0);
}

}  // namespace
}  // namespace raywalk::test
