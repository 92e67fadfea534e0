// A real GPU and the CPU: the same hits to the last bit, the same work, the same pixels whatever a kernel leaves out.
#include <cmath>
#include <cstring>

#include "server/device/cuda/traversal_types.h"
#include "server/scene/importer.h"
#include "tests/gpu/gpu.h"
#include "tests/support/frame_jobs.h"
#include "tests/support/small_scenes.h"

namespace raywalk {
namespace {

using cuda::traversal_types;
using cuda::TraversalType;
using test::room_job;
using test::SceneBlob;

class GpuHits : public test::GpuTest {};

std::string name_of(const TraversalType& type) {
  return std::string(type.structure) + "/" + std::string(type.traversal);
}

bool same_bits(const Hit& a, const Hit& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

FrameJob on(Device& device, const SceneBlob& scene, const TraversalType& type, Mode mode) {
  return room_job(device.build(scene, std::string(type.structure), {}), std::string(type.traversal), mode);
}

TEST_F(GpuHits, AreTheCpusOnEverySmallScene) {
  for (const test::NamedScene& named : test::small_scenes()) {
    const std::vector<Ray> rays = test::rays_for(named.scene);
    for (const TraversalType& type : traversal_types()) {
      const std::string kind(type.structure), traversal(type.traversal);
      const auto here = cpu().build(named.scene, kind, {}), there = gpu().build(named.scene, kind, {});
      const std::vector<Hit> expected = cpu().closest({here, traversal, rays});
      const std::vector<Hit> hits = gpu().closest({there, traversal, rays});
      const std::vector<u8> shadowed = cpu().occluded({here, traversal, rays});
      ASSERT_EQ(gpu().occluded({there, traversal, rays}), shadowed) << named.name << ", " << name_of(type);
      for (size_t i = 0; i < rays.size(); ++i) {
        const Hit &a = expected[i], &b = hits[i];
        ASSERT_TRUE(same_bits(a, b)) << named.name << ", " << name_of(type) << ", ray " << i << ": id " << b.id
                                     << " at " << b.t << " instead of " << a.id << " at " << a.t;
      }
    }
  }
}

TEST_F(GpuHits, InvalidRaysMiss) {
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  const Ray good{{0, 0, 0}, 0.0f, {0, -1, 0}, 100.0f};
  std::vector<Ray> rays{{{0, 0, 0}, 0.0f, {0, 0, 0}, 100.0f}};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (int field = 0; field < 8; ++field) {
      rays.push_back(good);
      reinterpret_cast<float*>(&rays.back())[field] = bad;
    }
  }
  const size_t invalid = rays.size();
  rays.push_back(good);
  for (const TraversalType& type : traversal_types()) {
    const RayJob asked{gpu().build(scene, std::string(type.structure), {}), std::string(type.traversal), rays};
    const std::vector<Hit> hits = gpu().closest(asked);
    const std::vector<u8> shadowed = gpu().occluded(asked);
    for (size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(hits[i].id == kMiss, i < invalid) << name_of(type) << ", ray " << i;
      EXPECT_EQ(shadowed[i] == 0, i < invalid) << name_of(type) << ", ray " << i;
    }
  }
}

TEST_F(GpuHits, OutputsOfPrimaryHitsAreTheCpus) {
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  for (const TraversalType& type : traversal_types()) {
    FrameJob here = on(cpu(), scene, type, Mode::primary), there = on(gpu(), scene, type, Mode::primary);
    for (const Output output : {Output::depth, Output::normal, Output::id, Output::steps}) {
      if (output == Output::steps && type.group > 1) continue;  // groups are formed in another way
      here.output = there.output = output;
      Frame expected, frame;
      cpu().render(here, expected);
      gpu().render(there, frame);
      EXPECT_EQ(frame.channels, expected.channels);
      EXPECT_EQ(frame.pixels, expected.pixels) << name_of(type) << ", output " << static_cast<int>(output);
    }
  }
}

TEST_F(GpuHits, WorkIsTheCpus) {
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  for (const TraversalType& type : traversal_types()) {
    if (type.group > 1) continue;
    for (const Mode mode : {Mode::primary, Mode::shadow, Mode::whitted}) {
      const Counts expected = cpu().count(on(cpu(), scene, type, mode));
      const Counts counts = gpu().count(on(gpu(), scene, type, mode));
      EXPECT_EQ(counts.rays, expected.rays) << name_of(type) << ", mode " << static_cast<int>(mode);
      EXPECT_EQ(counts.steps, expected.steps) << name_of(type) << ", mode " << static_cast<int>(mode);
      EXPECT_EQ(counts.tests, expected.tests) << name_of(type) << ", mode " << static_cast<int>(mode);
    }
  }
}

TEST_F(GpuHits, FramesAreTheSameWithFewestAndWithAllFeatures) {
  CudaConfig config;
  config.all_features = true;
  const auto complete = open_cuda_device(config);
  ASSERT_NE(complete.device, nullptr) << complete.why_not;
  const test::RoomOptions variants[] = {
      {}, {false, false, false, 1, false}, {true, false, true, 1, false}, {false, true, false, 3}};
  for (const test::RoomOptions& options : variants) {
    const SceneBlob scene = std::make_shared<const Blob>(test::room(options));
    for (const TraversalType& type : traversal_types()) {
      for (const Mode mode : {Mode::primary, Mode::shadow, Mode::whitted}) {
        Frame least, all, reference;
        gpu().render(on(gpu(), scene, type, mode), least);
        complete.device->render(on(*complete.device, scene, type, mode), all);
        ASSERT_EQ(least.pixels, all.pixels) << name_of(type) << ", mode " << static_cast<int>(mode);
        cpu().render(on(cpu(), scene, type, mode), reference);
        double sum = 0;
        for (size_t i = 0; i < all.pixels.size(); ++i) sum += std::pow(all.pixels[i] - reference.pixels[i], 2.0);
        EXPECT_LT(std::sqrt(sum / static_cast<double>(all.pixels.size())), 1e-4)
            << name_of(type) << ", mode " << static_cast<int>(mode);
      }
    }
  }
}

TEST_F(GpuHits, FewerLightsAreTheSceneWithFewerLights) {
  for (const TraversalType& type : traversal_types()) {
    for (const Mode mode : {Mode::primary, Mode::shadow, Mode::whitted}) {
      const auto image = [&](u32 lights_there, u32 lights_asked) {
        FrameJob job = on(gpu(), std::make_shared<const Blob>(test::room({.lights = lights_there})), type, mode);
        job.lights = lights_asked;
        Frame frame;
        gpu().render(job, frame);
        return frame.pixels;
      };
      for (const u32 lights : {0u, 1u, 3u})
        EXPECT_EQ(image(3, lights), image(lights, kAllLights)) << name_of(type) << ", " << lights << " lights";
      EXPECT_NE(image(3, 0), image(3, kAllLights)) << name_of(type);
    }
  }
}

TEST_F(GpuHits, OptionsOfTheKernelChangeNoHit) {
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  for (const TraversalType& type : traversal_types()) {
    FrameJob asked = on(gpu(), scene, type, Mode::primary);
    PrimaryHits expected;
    gpu().trace_primary(asked, expected);
    std::vector<OptionValues> variants{{{"registers", 32}}, {{"block", 32}}, {{"block", 512}}};
    if (type.structure == "kdtree") variants.insert(variants.end(), {{{"stack_entries", 1}}, {{"stack_entries", 16}}});
    for (const OptionValues& options : variants) {
      asked.kernel = options;
      PrimaryHits hits;
      gpu().trace_primary(asked, hits);
      for (size_t i = 0; i < hits.hits.size(); ++i)
        ASSERT_TRUE(same_bits(hits.hits[i], expected.hits[i]))
            << name_of(type) << ", " << options.begin()->first << " " << options.begin()->second << ", pixel " << i;
    }
  }
}

TEST_F(GpuHits, OfTheOtherTriangleTestAreNearlyTheSame) {
  constexpr double kFewestAlike = 0.998;  // at edges either triangle may be met, or a gap
  constexpr float kTolerance = 1e-4f;     // of t, relative
  const SceneBlob scene = std::make_shared<const Blob>(test::room({}));
  for (const TraversalType& type : traversal_types()) {
    FrameJob asked = on(gpu(), scene, type, Mode::primary);
    asked.width = asked.height = 256;
    PrimaryHits watertight, other;
    gpu().trace_primary(asked, watertight);
    asked.kernel = {{"intersector", 1}};
    gpu().trace_primary(asked, other);
    ASSERT_EQ(other.hits.size(), watertight.hits.size());
    size_t alike = 0, met = 0;
    for (size_t i = 0; i < other.hits.size(); ++i) {
      const Hit &a = watertight.hits[i], &b = other.hits[i];
      if (a.id != b.id) continue;
      ++alike;
      if (a.id == kMiss) continue;
      ++met;
      EXPECT_NEAR(b.t, a.t, kTolerance * a.t) << name_of(type) << ", pixel " << i;
    }
    EXPECT_GE(static_cast<double>(alike), kFewestAlike * static_cast<double>(other.hits.size())) << name_of(type);
    EXPECT_GT(met, other.hits.size() / 2) << name_of(type);
  }
}

/// Primary hits of every traversal against those of the CPU, bit for bit.
void expect_the_same(Device& cpu, Device& gpu, const std::filesystem::path& mesh) {
  const SceneBlob scene = std::make_shared<const Blob>(pack(load_mesh(mesh)));
  const Box bounds = scene->header<SceneHeader>().bounds;
  PrimaryHits expected;
  cpu.trace_primary(test::bunny_job(bounds, cpu.build(scene, "bvh", {}), "while-while"), expected);
  for (const TraversalType& type : traversal_types()) {
    if (type.structure == "brute") continue;
    const auto structure = gpu.build(scene, std::string(type.structure), {});
    PrimaryHits hits;
    gpu.trace_primary(test::bunny_job(bounds, structure, std::string(type.traversal)), hits);
    size_t different = 0, met = 0;
    for (size_t i = 0; i < hits.hits.size(); ++i) {
      different += !same_bits(hits.hits[i], expected.hits[i]);
      met += hits.hits[i].id != kMiss;
    }
    EXPECT_EQ(different, 0u) << name_of(type);
    EXPECT_GT(met, 20000u);
  }
}

TEST_F(GpuHits, AreTheCpusOnTheBunny) {
  const std::filesystem::path file = test::bunny_file();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the original bunny is not at " << file;
  expect_the_same(cpu(), gpu(), file);
}

TEST_F(GpuHits, AreTheCpusOnTheDragon) {
  const std::filesystem::path file = test::data_file("dragon/dragon_vrip_res2.ply.gz");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the original dragon is not at " << file;
  expect_the_same(cpu(), gpu(), file);
}

}  // namespace
}  // namespace raywalk
