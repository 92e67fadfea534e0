// Every structure and traversal of the CPU device on every small scene: hits equal to brute force to the last bit,
// frames equal to each other, Embree in agreement, invalid rays harmless.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "server/scene/importer.h"
#include "tests/support/frame_jobs.h"
#include "tests/support/small_scenes.h"

namespace raywalk {
namespace {

using test::bunny_file;
using test::NamedScene;
using test::rays_for;
using test::room_job;
using test::SceneBlob;
using test::small_scenes;

struct Technique {
  std::string kind, traversal;
};

class CpuDevice : public testing::Test {
 protected:
  static Device& device() {
    static const std::unique_ptr<Device> opened = open_cpu_device(2);
    return *opened;
  }
  /// Everything but the bare loops.
  static std::vector<Technique> techniques(bool with_brute = true) {
    std::vector<Technique> all;
    for (const KindInfo& kind : device().kinds())
      for (const TraversalInfo& traversal : kind.traversals)
        if (!traversal.baseline && (with_brute || kind.name != "brute")) all.push_back({kind.name, traversal.name});
    return all;
  }
  static std::vector<Hit> closest(const SceneBlob& scene, const Technique& technique, const std::vector<Ray>& rays) {
    return device().closest({device().build(scene, technique.kind, {}), technique.traversal, rays});
  }
};

TEST_F(CpuDevice, EveryTraversalHitsAsBruteForceDoes) {
  for (const NamedScene& named : small_scenes()) {
    const std::vector<Ray> rays = rays_for(named.scene);
    const std::vector<Hit> expected = closest(named.scene, {"brute", "loop"}, rays);
    for (const Technique& technique : techniques(false)) {
      if (technique.kind == "embree") continue;  // its triangle test is another one
      const std::vector<Hit> hits = closest(named.scene, technique, rays);
      const auto structure = device().build(named.scene, technique.kind, {});
      const std::vector<u8> occluded = device().occluded({structure, technique.traversal, rays});
      for (size_t i = 0; i < rays.size(); ++i) {
        const Hit &a = expected[i], &b = hits[i];
        ASSERT_TRUE(a.id == b.id && a.t == b.t && a.u == b.u && a.v == b.v)
            << named.name << ", " << technique.kind << "/" << technique.traversal << ", ray " << i << ": id " << b.id
            << " at " << b.t << " instead of " << a.id << " at " << a.t;
        ASSERT_EQ(occluded[i] != 0, a.id != kMiss)
            << named.name << ", " << technique.kind << "/" << technique.traversal << ", ray " << i;
      }
    }
  }
}

TEST_F(CpuDevice, EmbreeAgreesWhereARayIsNotAtAnEdge) {
  for (const NamedScene& named : small_scenes()) {
    const SceneView view{named.scene->data()};
    const Box bounds = view.triangle_count() ? view.header().bounds : Box{{-1, -1, -1}, {1, 1, 1}};
    const std::vector<Ray> rays = test::random_rays(11, 4000, bounds);
    const std::vector<Hit> ours = closest(named.scene, {"bvh", "while-while"}, rays);
    const std::vector<Hit> theirs = closest(named.scene, {"embree", "intersect"}, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
      const Hit &a = ours[i], &b = theirs[i];
      const bool at_edge = std::min({a.u, a.v, 1.0f - a.u - a.v, b.u, b.v, 1.0f - b.u - b.v}) < 1e-3f;
      if (a.id == b.id) {
        if (a.id != kMiss && named.name != "slivers") {
          EXPECT_NEAR(a.t, b.t, 1e-4f * std::max(1.0f, a.t)) << named.name;
        }
        continue;
      }
      const bool tie = a.id != kMiss && b.id != kMiss && std::abs(a.t - b.t) <= 1e-5f * std::max(1.0f, a.t);
      EXPECT_TRUE(at_edge || tie) << named.name << ", ray " << i << ": ids " << a.id << " and " << b.id << ", t " << a.t
                                  << " and " << b.t;
    }
  }
}

TEST_F(CpuDevice, EveryTraversalRendersTheSameFrame) {
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  for (Mode mode : {Mode::primary, Mode::shadow, Mode::whitted}) {
    Frame expected;
    device().render(room_job(device().build(scene, "brute", {}), "loop", mode), expected);
    EXPECT_GT(*std::max_element(expected.pixels.begin(), expected.pixels.end()), 0.1f);
    for (const Technique& technique : techniques(false)) {
      Frame frame;
      const auto structure = device().build(scene, technique.kind, {});
      device().render(room_job(structure, technique.traversal, mode), frame);
      if (technique.kind != "embree") {
        ASSERT_TRUE(frame.pixels == expected.pixels) << technique.kind << "/" << technique.traversal;
        continue;
      }
      double sum = 0;
      for (size_t i = 0; i < frame.pixels.size(); ++i) sum += std::pow(frame.pixels[i] - expected.pixels[i], 2.0);
      EXPECT_LT(std::sqrt(sum / static_cast<double>(frame.pixels.size())), 0.02) << "mode " << static_cast<int>(mode);
    }
  }
}

TEST_F(CpuDevice, FewerLightsAreTheSceneWithFewerLights) {
  for (const char* kind : {"bvh", "embree"}) {
    const auto image = [&](u32 lights_there, u32 lights_asked, Mode mode) {
      const auto structure =
          device().build(std::make_shared<const Blob>(test::room({.lights = lights_there})), kind, {});
      FrameJob job = room_job(structure, kind == std::string("bvh") ? "while-while" : "intersect", mode);
      job.lights = lights_asked;
      Frame frame;
      device().render(job, frame);
      return frame.pixels;
    };
    for (Mode mode : {Mode::primary, Mode::shadow, Mode::whitted}) {
      const auto three = image(3, kAllLights, mode);
      EXPECT_TRUE(image(3, 3, mode) == three);
      for (u32 lights = 0; lights < 3; ++lights) {
        const auto fewer = image(3, lights, mode);
        EXPECT_TRUE(fewer == image(lights, kAllLights, mode)) << kind << ", mode " << static_cast<int>(mode);
        EXPECT_FALSE(fewer == three);
      }
    }
  }
}

TEST_F(CpuDevice, OutputsFollowFromThePrimaryHits) {
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  for (const Technique& technique : techniques()) {
    FrameJob job = room_job(device().build(scene, technique.kind, {}), technique.traversal, Mode::primary);
    job.width = 80;  // whole blocks, so that packets are the same in a ray list and in a frame
    job.height = 48;
    PrimaryHits primary;
    device().trace_primary(job, primary);
    Frame frame;
    job.output = Output::id;
    device().render(job, frame);
    ASSERT_EQ(frame.channels, 1u);
    for (size_t i = 0; i < primary.hits.size(); ++i)
      ASSERT_EQ(frame.pixels[i], static_cast<float>(primary.hits[i].id));  // the room is closed: no misses
    job.output = Output::depth;
    device().render(job, frame);
    for (size_t i = 0; i < primary.hits.size(); ++i) ASSERT_EQ(frame.pixels[i], primary.hits[i].t);
    job.output = Output::normal;
    device().render(job, frame);
    ASSERT_EQ(frame.channels, 3u);
    for (size_t i = 0; i < primary.hits.size(); ++i)
      ASSERT_NEAR(std::hypot(frame.pixels[3 * i], frame.pixels[3 * i + 1], frame.pixels[3 * i + 2]), 1.0f, 1e-5f);
    job.output = Output::steps;
    device().render(job, frame);
    ASSERT_EQ(frame.channels, 2u);
    const Counts counts = device().count(job);
    EXPECT_EQ(counts.rays, u64{job.width} * job.height);
    if (!device().can_count(technique.kind)) continue;
    u64 steps = 0, tests = 0;
    for (size_t i = 0; i < primary.hits.size(); ++i) {
      steps += static_cast<u64>(frame.pixels[2 * i]);
      tests += static_cast<u64>(frame.pixels[2 * i + 1]);
    }
    EXPECT_EQ(counts.steps, steps) << technique.kind << "/" << technique.traversal;
    EXPECT_EQ(counts.tests, tests) << technique.kind << "/" << technique.traversal;
  }
}

TEST_F(CpuDevice, BareLoopsHitWhatTheTraversalHits) {
  const SceneBlob scene = std::make_shared<const Blob>(test::make_scene(test::icosphere(3)));
  FrameJob job = room_job(device().build(scene, "embree", {}), "intersect", Mode::primary);
  job.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 45};
  const auto hits_of = [&](const std::string& traversal) {
    job.traversal = traversal;
    PrimaryHits primary;
    device().trace_primary(job, primary);
    EXPECT_EQ(device().count(job).rays, u64{job.width} * job.height);
    return primary.hits;
  };
  const std::vector<Hit> expected = hits_of("intersect");
  for (const char* loop : {"loop-1", "loop-8"}) {
    const std::vector<Hit> hits = hits_of(loop);
    size_t different = 0, met = 0;
    for (size_t i = 0; i < hits.size(); ++i) {
      different += hits[i].id != expected[i].id;
      met += hits[i].id != kMiss;
    }
    EXPECT_GT(met, 500u);
    EXPECT_LE(different, 4u) << loop;  // packets and single rays may differ at an edge
  }
}

TEST_F(CpuDevice, InvalidRaysMissEverywhere) {
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const Ray good{{0, 0, 0}, 0.0f, {0, -1, 0}, 100.0f};
  std::vector<Ray> rays;
  for (float bad : {nan, inf, -inf}) {
    for (int field = 0; field < 8; ++field) {
      Ray ray = good;
      reinterpret_cast<float*>(&ray)[field] = bad;
      rays.push_back(ray);
    }
  }
  rays.push_back({{0, 0, 0}, 0.0f, {0, 0, 0}, 100.0f});
  rays.push_back({{0, 0, 0}, 0.0f, {-0.0f, 0, -0.0f}, 100.0f});
  const size_t invalid = rays.size();
  rays.push_back(good);
  for (const Technique& technique : techniques()) {
    const auto structure = device().build(scene, technique.kind, {});
    const auto hits = device().closest({structure, technique.traversal, rays});
    const auto occluded = device().occluded({structure, technique.traversal, rays});
    for (size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(hits[i].id == kMiss, i < invalid) << technique.kind << "/" << technique.traversal << ", ray " << i;
      EXPECT_EQ(occluded[i] == 0, i < invalid) << technique.kind << "/" << technique.traversal << ", ray " << i;
    }
  }
}

TEST_F(CpuDevice, RefusesWhatItDoesNotKnow) {
  const SceneBlob scene = std::make_shared<const Blob>(test::make_scene(test::icosphere(0)));
  EXPECT_THROW(device().build(scene, "octree", {}), std::invalid_argument);
  EXPECT_THROW(device().build(scene, "bvh", {{"no-such-option", 1.0}}), std::invalid_argument);
  EXPECT_THROW(device().build(scene, "grid", {{"resolution-x", -5.0}}), std::invalid_argument);
  Frame frame;
  EXPECT_THROW(device().render(room_job(device().build(scene, "bvh", {}), "dda", Mode::primary), frame),
               std::invalid_argument);
  FrameJob blind = room_job(device().build(scene, "bvh", {}), "packet", Mode::primary);
  blind.camera.target = blind.camera.eye;
  EXPECT_THROW(device().render(blind, frame), std::invalid_argument);
  blind.camera = {{-3.1973f, -4.31693f, -4.80525f}, {-2.72581f, -4.42221f, -5.68081f}, {}, 45};
  blind.camera.up = (blind.camera.target - blind.camera.eye) * 6.55f;  // along the view but for rounding
  EXPECT_THROW(device().render(blind, frame), std::invalid_argument);
}

TEST_F(CpuDevice, GridOfTheBunnyHasTheStudysReferences) {
  const std::filesystem::path file = bunny_file();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the original bunny is not at " << file;
  const SceneBlob scene = std::make_shared<const Blob>(pack(load_mesh(file)));
  OptionValues options;
  const auto by_density = device().build(scene, "grid", options);
  EXPECT_EQ(by_density->stats().leaves, 83u * 82u * 64u);
  options = {{"resolution_x", 83}, {"resolution_y", 82}, {"resolution_z", 64}};
  EXPECT_NEAR(static_cast<double>(device().build(scene, "grid", options)->stats().references), 256964, 256.9);
  options["insertion"] = 1;
  EXPECT_NEAR(static_cast<double>(device().build(scene, "grid", options)->stats().references), 208711, 208.7);
}

TEST_F(CpuDevice, AllStructuresSeeTheSameBunny) {
  const std::filesystem::path file = bunny_file();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the original bunny is not at " << file;
  const SceneBlob scene = std::make_shared<const Blob>(pack(load_mesh(file)));
  const Box bounds = scene->header<SceneHeader>().bounds;
  PrimaryHits expected;
  for (const Technique& technique : techniques(false)) {
    if (technique.kind == "embree") continue;
    const FrameJob job = test::bunny_job(bounds, device().build(scene, technique.kind, {}), technique.traversal);
    PrimaryHits hits;
    device().trace_primary(job, hits);
    if (expected.hits.empty()) expected = hits;
    size_t different = 0, met = 0;
    for (size_t i = 0; i < hits.hits.size(); ++i) {
      different += hits.hits[i].id != expected.hits[i].id || hits.hits[i].t != expected.hits[i].t;
      met += hits.hits[i].id != kMiss;
    }
    EXPECT_EQ(different, 0u) << technique.kind << "/" << technique.traversal;
    EXPECT_GT(met, 20000u);
  }
}

}  // namespace
}  // namespace raywalk
