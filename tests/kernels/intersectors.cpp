// Every structure and traversal finds with every intersector what brute force finds with the same one, bit for bit.
#include <gtest/gtest.h>

#include "kernels/accel/kind.h"
#include "kernels/entry_cpu.h"
#include "tests/support/meshes.h"

namespace raywalk::test {
namespace {

struct Tester {
  u32 row;
  const char* name;
  bool transforms = false;
};
// Rows of RW_INTERSECTORS.
constexpr Tester kTesters[] = {
    {0, "watertight"}, {1, "moeller-trumbore"}, {2, "exact"}, {3, "double"}, {4, "baldwin-weber", true}};

class Intersectors : public testing::TestWithParam<Tester> {};
/// Those whose error in hit and miss is at most that of the watertight test: structures are padded for it, whatever the
/// ray. The others have no bound at grazing angles and edges.
class BoundedIntersectors : public Intersectors {};

struct Traced {
  std::vector<Hit> hits;
  std::vector<u8> occluded;
};

Traced trace(const CpuTraversal& row, const TraceTarget& target, const std::vector<Ray>& rays) {
  Traced traced;
  traced.hits.resize(rays.size());
  traced.occluded.resize(rays.size());
  row.closest(target, rays.data(), rays.size(), traced.hits.data());
  row.occluded(target, rays.data(), rays.size(), traced.occluded.data());
  return traced;
}

bool same(const Hit& a, const Hit& b) {
  return a.id == b.id && bits_of(a.t) == bits_of(b.t) && bits_of(a.u) == bits_of(b.u) && bits_of(a.v) == bits_of(b.v);
}

const Kind& kind_named(std::string_view name) {
  for (const Kind* kind : kinds())
    if (kind->name == name) return *kind;
  throw std::invalid_argument("no such kind");
}

BuiltStructure build(const Kind& kind, SceneView scene, const Tester& tester, const OptionValues& options = {}) {
  OptionValues given = options;
  given["triangles"] = tester.transforms;
  return kind.build(scene, with_defaults(kind, given));
}

/// Returns how many rays hit.
u32 expect_like_brute(const Tester& tester, const Mesh& mesh, const std::vector<Ray>& rays) {
  const Blob blob = make_scene(mesh);
  const SceneView scene = view_of(blob);
  const Knobs knobs{.intersector = tester.row};
  Traced expected;
  for (const CpuTraversal& row : cpu_traversals()) {
    const BuiltStructure built = build(kind_named(row.kind), scene, tester);
    EXPECT_EQ(built.form.triangles == TriangleRecords::transforms, tester.transforms);
    const Traced traced = trace(row, {scene, built.blob.data(), knobs}, rays);
    if (expected.hits.empty()) expected = traced;  // brute force is the first row
    u32 wrong = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
      wrong += !same(traced.hits[i], expected.hits[i]);
      wrong += traced.occluded[i] != (expected.hits[i].id != kMiss);
    }
    EXPECT_EQ(wrong, 0u) << row.kind << '/' << row.name << ' ' << tester.name;
  }
  u32 hits = 0;
  for (const Hit& hit : expected.hits) hits += hit.id != kMiss;
  return hits;
}

TEST_P(Intersectors, RandomRaysThroughSoupsAndSpheres) {
  const Mesh soup = random_soup(3, 1500, 0.3f);
  EXPECT_GT(expect_like_brute(GetParam(), soup, random_rays(4, 2000, bounds_of(soup), 1.0f)), 500u);
  const Mesh sphere = icosphere(4, 2.0f, {1, 2, 3});
  EXPECT_GT(expect_like_brute(GetParam(), sphere, random_rays(5, 500, bounds_of(sphere), 1.0f)), 100u);
}

TEST_P(BoundedIntersectors, EdgesVerticesAndAxes) {
  for (const float offset : {0.0f, 1e4f}) {
    const Mesh sphere = transformed(icosphere(3), 1.0f, {offset, -offset, offset});
    std::vector<Ray> rays = edge_rays(6, 1000, sphere);
    for (const auto& more : {vertex_rays(7, 1000, sphere), axis_rays(8, 1000, sphere)}) {
      rays.insert(rays.end(), more.begin(), more.end());
    }
    EXPECT_GT(expect_like_brute(GetParam(), sphere, rays), 1500u);
  }
  const Mesh lattice = integer_lattice(3, 400, 4);
  EXPECT_GT(expect_like_brute(GetParam(), lattice, edge_rays(9, 1000, lattice)), 500u);
}

TEST_P(Intersectors, NonFiniteAndDegenerateTrianglesAreNeverHit) {
  Mesh mesh = random_soup(11, 200, 0.5f);
  const std::vector<Ray> rays = random_rays(12, 500, bounds_of(mesh));
  for (u32 i = 0; i < mesh.size(); ++i) {
    if (i % 2 == 0) mesh[i].b.x = i % 4 == 0 ? std::nanf("") : std::numeric_limits<float>::infinity();
    if (i % 2 == 1) mesh[i].b = i % 4 == 1 ? mesh[i].c : mesh[i].a;
  }
  EXPECT_EQ(expect_like_brute(GetParam(), mesh, rays), 0u);
}

TEST_P(Intersectors, AreRowsOfTheList) {
  const char* const names[] = {
#define RW_NAME(type, name, help) name,
      RW_INTERSECTORS(RW_NAME)
#undef RW_NAME
  };
  EXPECT_STREQ(names[GetParam().row], GetParam().name);
  EXPECT_EQ(std::size(names), std::size(kTesters));
}

constexpr auto kName = [](const auto& tester) {
  std::string name = tester.param.name;
  std::erase(name, '-');
  return name;
};
INSTANTIATE_TEST_SUITE_P(All, Intersectors, testing::ValuesIn(kTesters), kName);
INSTANTIATE_TEST_SUITE_P(Bounded, BoundedIntersectors, testing::Values(kTesters[0], kTesters[2], kTesters[3]), kName);

/// Packets and single rays through nodes of each precision.
TEST_P(Intersectors, NodesOfLowerPrecisionGiveTheSameHits) {
  const Tester tester = GetParam();
  for (const float offset : {0.0f, 1e5f}) {
    const Mesh mesh = transformed(icosphere(4, 2.0f), 1.0f, {offset, -offset, 0});
    const Blob blob = make_scene(mesh);
    const SceneView scene = view_of(blob);
    std::vector<Ray> rays = edge_rays(21, 500, mesh);
    for (const auto& more : {vertex_rays(22, 500, mesh), random_rays(23, 1000, bounds_of(mesh), 1.0f)})
      rays.insert(rays.end(), more.begin(), more.end());
    for (const CpuTraversal& row : cpu_traversals()) {
      if (row.kind != "bvh") continue;
      Traced expected;
      u64 size_bytes = 0;
      for (const u32 format : {0u, 1u, 2u}) {
        const BuiltStructure built = build(kind_named("bvh"), scene, tester, {{"nodes", format}});
        EXPECT_EQ(built.form.nodes, format);
        const Traced traced = trace(row, {scene, built.blob.data(), {.intersector = tester.row}}, rays);
        if (format == 0) {
          expected = traced;
          size_bytes = built.stats.size_bytes;
        }
        u32 wrong = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
          wrong += !same(traced.hits[i], expected.hits[i]);
          wrong += traced.occluded[i] != expected.occluded[i];
        }
        // The others may report a hit beyond what boxes are padded for: larger boxes find it, smaller ones do not.
        const bool bounded = tester.row != 1 && tester.row != 4;
        EXPECT_LE(wrong, bounded ? 0u : 4u) << row.name << ' ' << tester.name << " nodes " << format;
        if (format > 0) {
          EXPECT_LT(built.stats.size_bytes, size_bytes);
        }
      }
    }
  }
}

TEST(Transforms, CountInTheSizeOfAStructure) {
  const Blob blob = make_scene(random_soup(1, 1000));
  for (const Kind* kind : kinds()) {
    const BuiltStructure corners = build(*kind, view_of(blob), kTesters[0]);
    const BuiltStructure transforms = build(*kind, view_of(blob), kTesters[4]);
    const u64 more = transforms.stats.size_bytes - corners.stats.size_bytes;
    if (kind->name == "bvh") {
      EXPECT_EQ(more, 0u);  // in place of the corners
    } else {
      EXPECT_GE(more, 48000u) << kind->name;
    }
    EXPECT_EQ(transforms.stats.size_bytes, transforms.blob.size_bytes());
  }
}

TEST(Transforms, OfAPointGiveItsCoordinates) {
  for (const Corners& triangle : random_soup(2, 200, 1.0f)) {
    const Transform to = transform_of(triangle);
    const auto at = [&](Vec3 p) {
      const Vec3 q = turned(p, to.axis);
      const auto row = [&](Vec3 r) { return r.x * q.y + r.y * q.z + r.z; };
      return Vec3{row(to.to_u), row(to.to_v), row(to.to_plane) + q.x};
    };
    const float scale = 1e-6f + 1e-6f * largest(magnitude(to.to_u)) + 1e-6f * largest(magnitude(to.to_v));
    EXPECT_LE(length(at(triangle.a)), 4 * scale);
    EXPECT_LE(length(at(triangle.b) - Vec3{1, 0, 0}), 4 * scale);
    EXPECT_LE(length(at(triangle.c) - Vec3{0, 1, 0}), 4 * scale);
  }
}

}  // namespace
}  // namespace raywalk::test
