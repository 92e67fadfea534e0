// The comparison with a reference on one triangle: whose answers are judged, self-hits, shadow rays.
#include "server/bench/comparison.h"

#include <gtest/gtest.h>

#include "server/bench/shadow_rays.h"
#include "server/scene/scene.h"
#include "tests/server/fake_device.h"

namespace raywalk {
namespace {

/// A large triangle in z = 0 that a camera at z = 5 sees everywhere, and lamps on both sides of it.
std::shared_ptr<const Blob> triangle_and_lamps() {
  Scene scene;
  scene.positions = {{-100, -100, 0}, {100, -100, 0}, {0, 200, 0}};
  scene.triangles = {{0, 1, 2, 0}};
  scene.materials.emplace_back();
  scene.lights = {{{0, 0, 3}, {1, 1, 1}}, {{0, 0, -3}, {1, 1, 1}}};
  return std::make_shared<const Blob>(pack(scene));
}

/// Answers as it is told.
class ToldDevice : public test::FakeDevice {
 public:
  void trace_primary(const FrameJob& job, PrimaryHits& hits) override {
    hits.hits.assign(std::size_t{job.width} * job.height, hit);
  }
  std::vector<Hit> closest(const RayJob& job) override { return std::vector<Hit>(job.rays.size(), shadow_hit); }
  std::vector<u8> occluded(const RayJob& job) override { return std::vector<u8>(job.rays.size(), is_occluded); }

  Hit hit{5.0f, 0, 0.3f, 0.4f};
  Hit shadow_hit{1.0f, kMiss, 0, 0};
  u8 is_occluded = 0;
};

class ComparisonTest : public testing::Test {
 protected:
  ComparisonTest() {
    spec_.width = 4;
    spec_.height = 4;
    spec_.frames = 1;
    auto scene = std::make_shared<LoadedScene>();
    scene->info.name = "triangle";
    scene->blob = triangle_and_lamps();
    scene->camera_path.shape = SplinePath{{{{0, 0, 5}, {0, 0, 0}, 45}, {{0, 0, 6}, {0, 0, 0}, 45}}};
    scene_ = scene;
  }
  ErrorFigures compared(BenchMode mode) {
    const std::vector<Subject> references = {
        make_subject({"embree", "intersect"}, BenchMode::primary, {}, reference_.kinds())};
    Comparison comparison(spec_, *scene_, references, queue_, reference_queue_);
    ErrorFigures figures;
    comparison.add_rays(make_subject({"bvh", "while-while"}, mode, {}, device_.kinds()), 0, figures);
    return figures;
  }

  ToldDevice device_, reference_;
  DeviceQueue queue_{device_}, reference_queue_{reference_};
  BenchmarkSpec spec_;
  std::shared_ptr<LoadedScene> scene_;
};

TEST_F(ComparisonTest, WhatAgreesIsNotJudged) {
  const ErrorFigures figures = compared(BenchMode::primary);
  EXPECT_EQ(figures.primary.rays, 16u);
  EXPECT_EQ(figures.primary.judged, 0u);
  EXPECT_EQ(figures.shadow.rays, 0u);
  EXPECT_EQ(figures.wrong_rays(), 0u);
}

TEST_F(ComparisonTest, TheOracleSaysWhoIsWrong) {
  device_.hit = {1e30f, kMiss, 0, 0};
  const ErrorFigures ours = compared(BenchMode::primary);
  EXPECT_EQ(ours.id_mismatches, 16u);
  EXPECT_EQ(ours.primary.false_misses, 16u);
  EXPECT_EQ(ours.primary.reference_wrong, 0u);

  std::swap(device_.hit, reference_.hit);
  const ErrorFigures theirs = compared(BenchMode::primary);
  EXPECT_EQ(theirs.primary.right, 16u);
  EXPECT_EQ(theirs.primary.reference_wrong, 16u);
  EXPECT_EQ(theirs.wrong_rays(), 0u);
}

TEST_F(ComparisonTest, ShadowRaysGoToTheLampsOnTheLitSide) {
  const ErrorFigures figures = compared(BenchMode::shadow);
  EXPECT_EQ(figures.shadow.rays, 16u);
  EXPECT_EQ(figures.shadow.judged, 0u);
}

TEST_F(ComparisonTest, AnOcclusionByNothingIsAFalseHit) {
  device_.is_occluded = 1;
  const ErrorFigures figures = compared(BenchMode::whitted);
  EXPECT_EQ(figures.shadow.judged, 16u);
  EXPECT_EQ(figures.shadow.false_hits, 16u);
  EXPECT_EQ(figures.shadow.self_hits, 0u);
}

TEST_F(ComparisonTest, MeetingTheSurfaceThatIsLeftIsWrongEvenWhereTheReferenceDoesToo) {
  device_.is_occluded = reference_.is_occluded = 1;
  device_.shadow_hit.id = 0;
  const ErrorFigures figures = compared(BenchMode::shadow);
  EXPECT_EQ(figures.shadow.self_hits, 16u);
  EXPECT_EQ(figures.shadow.judged, 0u);
  EXPECT_EQ(figures.wrong_rays(), 16u);
}

class ShadowRaysTest : public testing::Test {
 protected:
  ShadowRays rays(const std::vector<Hit>& hits, u64 limit, const OptionValues& kernel = {}) {
    FrameJob job;
    job.camera = {{0, 0, 5}, {0, 0, 0}};
    job.width = static_cast<u32>(hits.size());
    job.height = 1;
    job.kernel = kernel;
    return shadow_rays(SceneView{scene_->data()}, job, hits, limit);
  }
  std::shared_ptr<const Blob> scene_ = triangle_and_lamps();
  const Hit hit_{5.0f, 0, 0.3f, 0.4f}, miss_{1e30f, kMiss, 0, 0};
};

TEST_F(ShadowRaysTest, LeaveHitsAndEndAtTheLamp) {
  const ShadowRays made = rays({hit_, miss_, hit_}, 100);
  ASSERT_EQ(made.rays.size(), 2u);
  EXPECT_EQ(made.origins, (std::vector<u32>{0, 0}));
  for (const Ray& ray : made.rays) {
    EXPECT_GT(ray.o.z, 0.0f) << "beside the surface, towards the lamp";
    EXPECT_LT(ray.o.z, 0.01f);
    EXPECT_EQ(ray.tmax, 1.0f);
    EXPECT_EQ(ray.o.z + ray.d.z, 3.0f);
  }
}

TEST_F(ShadowRaysTest, StartWhereTheSpawnOffsetSays) {
  EXPECT_EQ(rays({hit_}, 100, {{"spawn", 3.0}}).rays.at(0).o.z, 0.0f);         // none
  EXPECT_FLOAT_EQ(rays({hit_}, 100, {{"spawn", 2.0}}).rays.at(0).o.z, 1e-4f);  // constant
}

TEST_F(ShadowRaysTest, AreNoMoreThanTheLimit) {
  const std::vector<Hit> many(1000, hit_);
  EXPECT_EQ(rays(many, 1'000'000).rays.size(), 1000u);
  const std::size_t some = rays(many, 100).rays.size();  // of 100 pairs with a lamp, those on the lit side
  EXPECT_LE(some, 100u);
  EXPECT_TRUE(rays({miss_}, 100).rays.empty());
  EXPECT_TRUE(rays(many, 0).rays.empty());
  EXPECT_THROW(shadow_rays(SceneView{scene_->data()}, {}, many, 1), std::logic_error);
}

}  // namespace
}  // namespace raywalk
