// The uniform grid: hits as brute force, cells and references as specified, limits of memory, same bytes always.
#include <tbb/global_control.h>

#include <cstring>
#include <stdexcept>

#include "kernels/accel/grid/dda.h"
#include "kernels/accel/grid/kind.h"
#include "tests/support/spatial_cases.h"

namespace raywalk::test {
namespace {

const auto kTrace = [](auto&&... arguments) { grid::dda::traverse(arguments...); };

OptionValues resolution(double x, double y, double z, bool exact = false) {
  return {{"resolution_x", x}, {"resolution_y", y}, {"resolution_z", z}, {"insertion", exact ? 1 : 0}};
}

BuiltStructure build_grid(const Blob& scene, const OptionValues& options = {}) {
  return grid::kind().build(view_of(scene), options_of(grid::kind(), options));
}

TEST(Grid, HitsAsBruteForce) {
  const OptionValues variants[] = {
      {}, {{"insertion", 1}}, resolution(8, 8, 8), resolution(1, 1, 1), resolution(37, 5, 64, true)};
  for (const SpatialCase& c : spatial_cases()) {
    const Blob scene = make_scene(c.mesh);
    const std::vector<Answer> answers = brute_force(view_of(scene), c.rays);
    for (size_t i = 0; i < std::size(variants); ++i) {
      const BuiltStructure grid = build_grid(scene, variants[i]);
      expect_answers(answers, view_of(scene), grid.blob.data(), c.rays, kTrace,
                     c.name + ", variant " + std::to_string(i));
    }
  }
}

TEST(Grid, SkipsNoCellAtHighResolution) {
  const Mesh mesh = random_soup(31, 40, 0.05f);
  const Blob scene = make_scene(mesh);
  const std::vector<Ray> rays = mixed_rays(32, 1500, mesh);
  for (const OptionValues& options : {resolution(1024, 1024, 1), resolution(256, 256, 256), resolution(1, 4096, 64)}) {
    const BuiltStructure grid = build_grid(scene, options);
    expect_same_as_brute(view_of(scene), grid.blob.data(), rays, kTrace, "fine grid");
  }
}

TEST(Grid, StepsStayWithinTheSumOfTheResolutions) {
  const Mesh mesh = integer_lattice(33, 50, 16);
  const Blob scene = make_scene(mesh);
  const BuiltStructure grid = build_grid(scene, resolution(40, 50, 60));
  for (const Ray& ray : lattice_rays(34, 2000, 16)) {
    Counter counter;
    AnyHit query(ray);
    kTrace(grid.blob.data(), view_of(scene), ray, query, counter);
    EXPECT_LE(counter.counts.steps, 40u + 50u + 60u);
  }
}

TEST(Grid, ManyIdenticalTrianglesKeepTheLowestId) {
  const Mesh mesh = repeated({triangle({0, 0, 0}, {1, 0, 0.5f}, {0, 1, 0.25f})}, 100000);
  const Blob scene = make_scene(mesh);
  const BuiltStructure grid = build_grid(scene, {});  // the density gives way: the triangles fill all cells
  EXPECT_LT(grid.stats.references, 64u * 100000u + (1u << 24));
  expect_same_as_brute(view_of(scene), grid.blob.data(), mixed_rays(35, 10, mesh), kTrace, "identical");
}

TEST(Grid, ExactInsertionIsASubsetOfBounds) {
  const Blob scene = make_scene(random_soup(36, 2000, 0.6f));
  const BuiltStructure bounds = build_grid(scene, resolution(24, 24, 24));
  const BuiltStructure exact = build_grid(scene, resolution(24, 24, 24, true));
  EXPECT_LT(exact.stats.references, bounds.stats.references);
  const auto& a = bounds.blob.header<grid::Header>();
  const auto& b = exact.blob.header<grid::Header>();
  const auto cell_of = [](const Blob& blob, const grid::Header& header, u32 cell) {
    const u32* begins = data_of(blob.data(), header.begins);
    return slice_of(blob, header.references).subspan(begins[cell], begins[cell + 1] - begins[cell]);
  };
  for (u32 cell = 0; cell < 24 * 24 * 24; ++cell) {
    const auto all = cell_of(bounds.blob, a, cell), some = cell_of(exact.blob, b, cell);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
  }
}

TEST(Grid, ReferencesOfKnownScene) {
  // Eight quads a side on an 8 x 8 grid: with padding each triangle reaches into the neighbours of its cell.
  const Blob scene = make_scene(quad_grid(8));
  const BuiltStructure grid = build_grid(scene, resolution(8, 8, 1));
  EXPECT_EQ(grid.stats.references, 2u * 22 * 22);
  EXPECT_EQ(grid.stats.leaves, 64u);
  EXPECT_EQ(grid.stats.size_bytes, grid.blob.size_bytes());
}

TEST(Grid, ResolutionByDensity) {
  const Blob cube = make_scene(random_soup(37, 8000, 0.01f));
  const BuiltStructure grid = build_grid(cube, {{"density", 8.0}});
  for (const u32 n : grid.stats.resolution) EXPECT_NEAR(n, 40, 1);
  const Blob flat = make_scene(quad_grid(50));
  const BuiltStructure thin = build_grid(flat, {{"density", 2.0}});
  EXPECT_NEAR(thin.stats.resolution[0], 100, 1);
  EXPECT_EQ(thin.stats.resolution[2], 1u);
}

TEST(Grid, RefusesWhatMemoryCannotHold) {
  const Blob scene = make_scene(random_soup(38, 1000, 2.0f));
  EXPECT_THROW(build_grid(scene, resolution(16384, 16384, 16384)), std::invalid_argument);
  EXPECT_THROW(build_grid(scene, resolution(1e6, 1, 1)), std::invalid_argument);
  EXPECT_THROW(build_grid(scene, resolution(640, 640, 640)), std::invalid_argument);
}

TEST(Grid, SameBytesWithAnyNumberOfThreads) {
  const Blob scene = make_scene(random_soup(39, 30000, 0.1f));
  for (const OptionValues& options : {OptionValues{}, OptionValues{{"insertion", 1}}}) {
    const BuiltStructure many = build_grid(scene, options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const BuiltStructure single = build_grid(scene, options);
    ASSERT_EQ(many.stats.references, single.stats.references);
    const auto& header = many.blob.header<grid::Header>();
    const auto bytes = [&](const Blob& blob, auto slice) { return std::as_bytes(slice_of(blob, slice)); };
    EXPECT_TRUE(std::ranges::equal(bytes(many.blob, header.begins), bytes(single.blob, header.begins)));
    EXPECT_TRUE(std::ranges::equal(bytes(many.blob, header.references), bytes(single.blob, header.references)));
  }
}

TEST(Grid, BlobMayMove) {
  const Mesh mesh = random_soup(40, 500);
  const Blob scene = make_scene(mesh);
  Blob copy;
  {
    const BuiltStructure grid = build_grid(scene);
    copy = Blob(grid.blob.size_bytes());
    std::memcpy(copy.data(), grid.blob.data(), copy.size_bytes());
  }
  expect_same_as_brute(view_of(scene), copy.data(), mixed_rays(41, 200, mesh), kTrace, "moved");
}

}  // namespace
}  // namespace raywalk::test
