// A benchmark's measurements on a device that is not there: launches, kernels, sensors, and the engine of references.
#include "server/bench/session.h"

#include <gtest/gtest.h>

#include "server/bench/validation.h"
#include "tests/server/fake_device.h"
#include "tests/server/fake_scene.h"

namespace raywalk {
namespace {

using namespace std::chrono_literals;

class SessionTest : public testing::Test {
 protected:
  SessionTest() {
    spec_.scene = "a";
    spec_.width = 4;
    spec_.height = 2;
    spec_.frames = 20;
    spec_.warmup = 1;
  }
  Subject subject(const TechniqueSpec& technique, BenchMode mode = BenchMode::primary) {
    return make_subject(technique, mode, structures_.build_and_wait(scene_, technique.structure, technique.options),
                        device_.kinds());
  }
  Session measured(const std::vector<Subject>& subjects) {
    return measure_alone(spec_, *scene_, subjects, queue_, [&](const SessionProgress& p) {
      stages_.push_back(p.stage);
      EXPECT_LE(p.frames_done, p.frames_total);
    });
  }

  test::FakeDevice device_;
  DeviceQueue queue_{device_};
  Structures structures_{queue_, device_.kinds()};
  ScenePtr scene_ = test::scene_named("a");
  BenchmarkSpec spec_;
  std::vector<std::string> stages_;
};

TEST_F(SessionTest, SingleFramesThenFullLaunches) {
  const Session session = measured({subject({"bvh", "while-while"})});
  std::vector<std::size_t> expected(21, 1);
  expected.insert(expected.end(), 3, 16);  // a warm-up, then frames 0 to 15 and 4 to 19
  EXPECT_EQ(device_.launches, expected);
  EXPECT_EQ(session.frames_per_launch, 16u);
  EXPECT_EQ(session.frames, 21u + 3 * 16);
  ASSERT_TRUE(session.batched);
  EXPECT_EQ(session.single.ms[0], std::vector<std::vector<double>>(20, {2.0}));
  EXPECT_EQ(session.batched->ms[0], (std::vector<std::vector<double>>{{1.0}, {1.0}}));  // of a frame
  EXPECT_EQ(stages_.front(), "waiting for the device");
  EXPECT_EQ(stages_.back(), "measuring throughput of bvh/while-while");
}

TEST_F(SessionTest, NoThroughputWhereItIsNotWanted) {
  spec_.batch = 0;
  EXPECT_FALSE(measured({subject({"bvh", "while-while"})}).batched);
  spec_.batch = 16;
  spec_.frames = 1;
  EXPECT_FALSE(measured({subject({"bvh", "while-while"})}).batched);
  EXPECT_EQ(device_.launches, std::vector<std::size_t>(21 + 2, 1));
}

TEST_F(SessionTest, FewFramesAreOneLaunch) {
  spec_.frames = 5;
  EXPECT_EQ(measured({subject({"bvh", "while-while"})}).frames_per_launch, 5u);
}

TEST_F(SessionTest, LaunchesBecomeSmallerWhereMemoryEnds) {
  device_.most_frames["pair"] = 5;
  const Session session = measured({subject({"bvh", "while-while"}), subject({"bvh", "pair"})});
  EXPECT_EQ(session.frames_per_launch, 4u) << "for both, so that they can be compared";
  ASSERT_TRUE(session.batched);
  EXPECT_EQ(session.batched->ms[0], std::vector<std::vector<double>>(5, {1.0}));
  EXPECT_EQ(session.batched->ms[1], std::vector<std::vector<double>>(5, {1.0}));
  EXPECT_EQ(session.single.ms[0].size(), 20u);
  ASSERT_EQ(session.notes.size(), 1u);
  EXPECT_NE(session.notes[0].find("4 frames a launch, not 16"), std::string::npos) << session.notes[0];
}

TEST_F(SessionTest, AThroughputThatHasNoMemoryIsLeftOut) {
  device_.most_frames["while-while"] = 1;
  const std::vector<Subject> subjects = {subject({"bvh", "while-while"}), subject({"bvh", "pair"})};
  const Session session = measured(subjects);
  ASSERT_TRUE(session.batched);
  EXPECT_EQ(session.frames_per_launch, 2u);
  EXPECT_TRUE(session.batched->ms[0].empty());
  EXPECT_EQ(session.batched->ms[1], std::vector<std::vector<double>>(10, {1.0}));
  EXPECT_EQ(session.single.ms[0], std::vector<std::vector<double>>(20, {2.0}));
  ASSERT_EQ(session.notes.size(), 2u);
  EXPECT_NE(session.notes[1].find("bvh/while-while in mode primary is missing"), std::string::npos) << session.notes[1];

  device_.most_frames["pair"] = 1;
  const Session none = measured(subjects);
  EXPECT_FALSE(none.batched);
  EXPECT_EQ(none.frames, 2u * 21);
  EXPECT_EQ(none.single.ms[1], std::vector<std::vector<double>>(20, {2.0}));
  EXPECT_EQ(none.kernels.size(), 2u);
  EXPECT_EQ(none.notes.size(), 2u);
}

TEST_F(SessionTest, KernelOptionsReachTheDeviceAndTheNames) {
  const Subject capped = subject({"bvh", "while-while", {{"bins", 16.0}}, {{"registers", 40.0}}});
  const Subject plain = subject({"bvh", "while-while", {}, {{"registers", 0.0}}});
  EXPECT_EQ(capped.name, "bvh/while-while bins=16 registers=40");
  EXPECT_EQ(plain.name, "bvh/while-while");
  const Session session = measured({capped, plain});
  EXPECT_EQ(device_.kernels.at(1).at("registers"), 0);  // the second one's warm-up
  EXPECT_EQ(device_.kernels.at(2), (OptionValues{{"registers", 40}, {"test", 0}, {"block", 128}}));
  EXPECT_EQ(session.kernels.at(0)->registers, 40u);
  EXPECT_EQ(session.kernels.at(1)->registers, 0u);
}

TEST_F(SessionTest, SensorsAreReadWhileItMeasures) {
  EXPECT_FALSE(measured({subject({"bvh", "while-while"})}).telemetry);
  device_.has_sensors = true;
  const Session session = measured({subject({"bvh", "while-while"})});
  ASSERT_TRUE(session.telemetry);
  EXPECT_EQ(session.telemetry->core_clock_mhz.min, 1.0);
  EXPECT_EQ(session.telemetry->core_clock_mhz.max, static_cast<double>(device_.readings));
  EXPECT_EQ(session.telemetry->power_limit_w, 700.0);
}

TEST_F(SessionTest, ReferencesComeFromTheirOwnEngine) {
  test::FakeDevice other;
  other.hit_id = 7;
  DeviceQueue other_queue(other);
  Structures other_structures(other_queue, other.kinds());
  const std::vector<Subject> subjects = {subject({"bvh", "while-while"}), subject({"bvh", "pair"}, BenchMode::trace)};
  const TechniqueSpec technique = reference_of(subjects[0].technique);
  const std::vector<Subject> references = {
      make_subject(technique, BenchMode::primary,
                   other_structures.build_and_wait(scene_, technique.structure, technique.options), other.kinds())};
  Comparison comparison(spec_, *scene_, references, queue_, other_queue);
  const std::vector<Validation> validations = validate(spec_, *scene_, subjects, comparison, queue_, [](double) {});
  ASSERT_EQ(validations.size(), 2u);
  for (const Validation& validation : validations) {
    EXPECT_EQ(validation.error.reference, "embree/intersect robust=on");
    EXPECT_EQ(validation.error.pixels, 4u * 8);  // 4 frames
    EXPECT_EQ(validation.error.id_mismatches + validation.error.ties, 4u * 8);
    EXPECT_EQ(validation.counts.rays, 4u * 8);
  }
  EXPECT_EQ(structures_.resident_count(), 1u);  // no Embree beside the measured ones
}

TEST(TelemetrySummary, RangesMediansAndAllReasons) {
  const std::vector<Telemetry> readings = {{1500, 2600, 300, 650, 40, {"power"}},
                                           {1900, 2600, 500, 700, 55, {}},
                                           {1700, 2600, 450, 700, 60, {"heat", "power"}}};
  const std::optional<TelemetrySummary> summary = summarise_readings(readings);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->core_clock_mhz.min, 1500);
  EXPECT_EQ(summary->core_clock_mhz.median, 1700);
  EXPECT_EQ(summary->core_clock_mhz.max, 1900);
  EXPECT_EQ(summary->power_w.median, 450);
  EXPECT_EQ(summary->temperature_c.max, 60);
  EXPECT_EQ(summary->power_limit_w, 700);
  EXPECT_EQ(summary->throttle_reasons, (std::vector<std::string>{"heat", "power"}));
  EXPECT_FALSE(summarise_readings({}));
}

TEST(TelemetrySampler, ReadsAgainAndAgain) {
  test::FakeDevice device;
  device.has_sensors = true;
  TelemetrySampler sampler(device, 1ms);
  while (device.readings < 5) std::this_thread::sleep_for(1ms);
  const std::size_t count = sampler.stop().size();
  EXPECT_EQ(count, device.readings);
  EXPECT_EQ(sampler.stop().size(), count);
}

TEST(TelemetrySampler, AsksOnceWhereThereAreNoSensors) {
  test::FakeDevice device;
  TelemetrySampler sampler(device, 1ms);
  EXPECT_TRUE(sampler.stop().empty());
}

}  // namespace
}  // namespace raywalk
