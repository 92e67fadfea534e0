// A structure is used by the traversals that can read it, and refused to all others.
#include <gtest/gtest.h>

#include <algorithm>

#include "server/device/device.h"
#include "server/device/knobs.h"
#include "tests/support/meshes.h"

namespace raywalk::test {
namespace {

constexpr double kBaldwinWeber = 4, kIze = 1, kTransforms = 1, kHalf = 1;

class StructureForms : public testing::Test {
 protected:
  StructureForms() : scene_(std::make_shared<const Blob>(make_scene(icosphere(2)))), device_(open_cpu_device(1)) {}

  std::vector<Hit> closest(const char* kind, const char* traversal, const OptionValues& options,
                           const OptionValues& kernel) {
    const std::vector<Ray> rays = random_rays(1, 100, Box{{-1, -1, -1}, {1, 1, 1}}, 1.0f);
    return device_->closest({device_->build(scene_, kind, options), traversal, rays, kernel});
  }
  std::shared_ptr<const Blob> scene_;
  std::unique_ptr<Device> device_;
};

TEST_F(StructureForms, GoWithTheRightIntersector) {
  for (const auto& [kind, traversal] :
       {std::pair{"brute", "loop"}, {"grid", "dda"}, {"kdtree", "short-stack-3"}, {"bvh", "packet"}}) {
    const auto hits = closest(kind, traversal, {{"triangles", kTransforms}}, {{"intersector", kBaldwinWeber}});
    EXPECT_TRUE(std::ranges::any_of(hits, [](const Hit& hit) { return hit.id != kMiss; })) << kind;
    EXPECT_THROW(closest(kind, traversal, {{"triangles", kTransforms}}, {}), std::invalid_argument) << kind;
    EXPECT_THROW(closest(kind, traversal, {}, {{"intersector", kBaldwinWeber}}), std::invalid_argument) << kind;
  }
}

TEST_F(StructureForms, AreRefusedForFramesAndMeasurementsToo) {
  FrameJob job;
  job.structure = device_->build(scene_, "bvh", {{"triangles", kTransforms}});
  job.traversal = "while-while";
  job.camera.eye = {0, 0, 5};
  job.camera.target = {0, 0, 0};
  job.camera.up = {0, 1, 0};
  job.width = job.height = 8;
  Frame frame;
  PrimaryHits hits;
  EXPECT_THROW(device_->render(job, frame), std::invalid_argument);
  EXPECT_THROW(device_->trace_primary(job, hits), std::invalid_argument);
  EXPECT_THROW(device_->measure({&job, 1}, Work::frame), std::invalid_argument);
  EXPECT_THROW(device_->measure({&job, 1}, Work::trace), std::invalid_argument);
  EXPECT_THROW(device_->count(job), std::invalid_argument);
  job.kernel = {{"intersector", kBaldwinWeber}};
  device_->render(job, frame);
  EXPECT_EQ(frame.pixels.size(), 8u * 8 * 3);
}

TEST_F(StructureForms, NodesOfLowerPrecisionTakeOneBoxTest) {
  const auto precise = closest("bvh", "while-while", {}, {});
  const auto half = closest("bvh", "while-while", {{"nodes", kHalf}}, {});
  ASSERT_EQ(half.size(), precise.size());
  for (size_t i = 0; i < half.size(); ++i) EXPECT_EQ(half[i].id, precise[i].id);
  EXPECT_THROW(closest("bvh", "while-while", {{"nodes", kHalf}}, {{"slab", kIze}}), std::invalid_argument);
}

TEST_F(StructureForms, TheRefusalNamesBoth) {
  const std::string why = why_unfit({TriangleRecords::transforms, 0}, {});
  EXPECT_NE(why.find("watertight"), std::string::npos) << why;
  EXPECT_NE(why.find("triangles=transforms"), std::string::npos) << why;
  EXPECT_EQ(why_unfit({}, {}), "");
}

}  // namespace
}  // namespace raywalk::test
