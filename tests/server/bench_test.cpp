// Statistics, the measuring loop with techniques that do nothing, error figures.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "server/bench/errors.h"
#include "server/bench/measure.h"
#include "server/bench/statistics.h"
#include "server/bench/subject.h"

namespace raywalk {
namespace {

std::vector<std::vector<double>> one_each(std::vector<double> values) {
  std::vector<std::vector<double>> frames;
  for (const double v : values) frames.push_back({v});
  return frames;
}

TEST(Statistics, OfKnownNumbers) {
  const Statistics s = summarise(one_each({5, 1, 4, 2, 3}));
  EXPECT_EQ(s.samples, 5u);
  EXPECT_DOUBLE_EQ(s.median, 3);
  EXPECT_DOUBLE_EQ(s.mean, 3);
  EXPECT_DOUBLE_EQ(s.sd, std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(s.mad, 1);
  EXPECT_DOUBLE_EQ(s.min, 1);
  EXPECT_DOUBLE_EQ(s.p5, 1.2);
  EXPECT_DOUBLE_EQ(s.p95, 4.8);
  EXPECT_FALSE(s.unstable);
}

TEST(Statistics, OfOneSample) {
  const Statistics s = summarise(one_each({7}));
  EXPECT_DOUBLE_EQ(s.median, 7);
  EXPECT_DOUBLE_EQ(s.sd, 0);
  EXPECT_DOUBLE_EQ(s.ci95_low, 7);
  EXPECT_DOUBLE_EQ(s.ci95_high, 7);
}

TEST(Statistics, NoSamplesIsAnErrorAndNotANumber) {
  EXPECT_THROW(summarise({}), std::invalid_argument);
  EXPECT_THROW(summarise(std::vector<std::vector<double>>(3)), std::invalid_argument);
}

TEST(Statistics, BootstrapIsDeterministicAndCoversTheMedian) {
  std::mt19937 random(3);
  int covered = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values(41);
    for (double& v : values) v = static_cast<double>(random() % 100'000) * 1e-5;  // median 0.5
    const Statistics s = summarise(one_each(values)), again = summarise(one_each(values));
    EXPECT_EQ(s.ci95_low, again.ci95_low);
    EXPECT_LE(s.ci95_low, s.median);
    EXPECT_GE(s.ci95_high, s.median);
    covered += s.ci95_low <= 0.5 && 0.5 <= s.ci95_high;
  }
  EXPECT_GT(covered, kTrials * 0.90);
  EXPECT_LT(covered, kTrials);
}

TEST(Statistics, StabilityLooksAtRepeatsNotAtFrames) {
  EXPECT_FALSE(summarise(std::vector<std::vector<double>>{{1, 1.01}, {50, 50.5}, {9, 9.1}}).unstable);
  EXPECT_TRUE(summarise(std::vector<std::vector<double>>{{1, 1.2}, {50, 41}, {9, 9.9}}).unstable);
  EXPECT_NEAR(pooled_spread(std::vector<std::vector<double>>{{0.9, 1.1}, {90, 110}}), 0.1 * std::sqrt(2.0), 1e-12);
}

/// Takes no time; writes down who was called.
class NullTechnique : public Technique {
 public:
  NullTechnique(char name, std::string& log) : name_(name), log_(log) {}
  double measure(u32 first, u32 frames) override {
    log_ += name_;
    log_ += std::to_string(first);
    if (frames > 1) log_ += "+" + std::to_string(frames);
    return frames * (first + 1.0);
  }

 private:
  char name_;
  std::string& log_;
};

TEST(Measure, InterleavesFrameByFrameAfterTheWarmUp) {
  std::string log;
  NullTechnique a('a', log), b('b', log);
  Technique* const techniques[] = {&a, &b};
  u64 calls = 0, last_total = 0;
  const Measurements m = measure(techniques, {.frames = 2, .warmup = 1, .repeats = 2}, [&](u64 done, u64 total) {
    EXPECT_EQ(done, calls++);
    last_total = total;
  });
  EXPECT_EQ(log,
            "a0b0"
            "a0b0a1b1"
            "a0b0a1b1");
  EXPECT_EQ(calls, last_total);
  EXPECT_FALSE(m.reached_time_limit);
  EXPECT_EQ(m.ms[0][1], (std::vector<double>{2, 2}));
}

TEST(Measure, TakesTurnsLaunchByLaunch) {
  std::string log;
  NullTechnique a('a', log), b('b', log);
  Technique* const techniques[] = {&a, &b};
  u64 frames = 0, last_total = 0;
  const MeasurePlan plan{.frames = 10, .per_launch = 4, .warmup = 1};
  const Measurements m = measure(techniques, plan, [&](u64 done, u64 total) {
    EXPECT_EQ(done, frames);
    frames += 4;
    last_total = total;
  });
  EXPECT_EQ(log,
            "a0+4b0+4"
            "a0+4b0+4a4+4b4+4a6+4b6+4");  // the last launch is full too
  EXPECT_EQ(frames, last_total);
  EXPECT_EQ(m.ms[1], (std::vector<std::vector<double>>{{1}, {5}, {7}}));  // of one frame
}

TEST(Measure, StopsAtTheTimeLimitWithEqualSamples) {
  std::string log;
  NullTechnique a('a', log), b('b', log);
  Technique* const techniques[] = {&a, &b};
  const Measurements m = measure(techniques, {.frames = 5, .time_limit_s = 0}, [](u64, u64) {});
  EXPECT_TRUE(m.reached_time_limit);
  EXPECT_EQ(log, "a0b0");
}

TEST(Measure, AnExceptionEndsIt) {
  std::string log;
  NullTechnique a('a', log);
  Technique* const techniques[] = {&a};
  EXPECT_THROW(measure(techniques, {.frames = 9},
                       [](u64 done, u64) {
                         if (done == 3) throw std::runtime_error("stop");
                       }),
               std::runtime_error);
  EXPECT_EQ(log, "a0a1a2");
}

TEST(Errors, TiesAreNotMismatches) {
  const float t = 2.5f;
  const Hit reference[] = {{t, 1, 0, 0}, {t, 2, 0, 0}, {t, 3, 0, 0}, {t, 4, 0, 0}, {t, kMiss, 0, 0}};
  const Hit hits[] = {{t, 1, 0, 0},
                      {std::nextafter(std::nextafter(t, 9.0f), 9.0f), 7, 0, 0},
                      {t + 1e-3f, 8, 0, 0},
                      {t, kMiss, 0, 0},
                      {t, kMiss, 0, 0}};
  ErrorFigures e;
  compare_hits(reference, hits, e);
  EXPECT_EQ(e.pixels, 5u);
  EXPECT_EQ(e.ties, 1u);
  EXPECT_EQ(e.id_mismatches, 2u);
  EXPECT_DOUBLE_EQ(e.mismatch_ppm(), 4e5);
  EXPECT_THROW(compare_hits(reference, std::span(hits, 2), e), std::logic_error);
}

TEST(Errors, UpperBoundFollowsTheRuleOfThree) {
  ErrorFigures e;
  e.pixels = 1'000'000;
  EXPECT_DOUBLE_EQ(e.mismatch_ppm_upper95(), 3.0);
  e.id_mismatches = 10;  // the exact Poisson limit is 16.96
  EXPECT_NEAR(e.mismatch_ppm_upper95(), 16.96, 0.05);
}

Frame image_of(std::vector<float> pixels) {
  return {.width = static_cast<u32>(pixels.size() / 3), .height = 1, .channels = 3, .pixels = std::move(pixels)};
}

TEST(Errors, ImagesAreComparedAsTheyAreSeen) {
  ErrorFigures e;
  const Frame black = image_of({0, 0, 0}), white = image_of({1, 1, 1}), brighter = image_of({9, 9, 9});
  compare_images(black, white, e);
  EXPECT_DOUBLE_EQ(e.image_rmse(), 1.0);
  ErrorFigures same;
  compare_images(white, brighter, same);  // both are shown as white
  EXPECT_EQ(same.image_rmse(), 0.0);
}

TEST(Errors, OfSeveralImagesAreMeansAndTheWorst) {
  const Frame black = image_of({0, 0, 0, 0, 0, 0}), white = image_of({1, 1, 1, 1, 1, 1});
  ErrorFigures e;
  EXPECT_FALSE(e.image_ssim().has_value());
  EXPECT_FALSE(e.image_flip_mean().has_value());
  EXPECT_FALSE(e.changed_pixels_ppm().has_value());
  compare_images(black, white, e);
  const double flip = *e.image_flip_max();
  compare_images(black, black, e);
  EXPECT_NEAR(e.image_rmse(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(*e.image_ssim(), 0.50005, 1e-6);
  EXPECT_NEAR(*e.image_flip_mean(), flip / 2, 1e-6);
  EXPECT_EQ(*e.image_flip_max(), flip);
  EXPECT_NEAR(*e.image_flip_p99(), flip, 1e-6);
  EXPECT_EQ(*e.changed_pixels_ppm(), 5e5);
}

TEST(Subject, ErrorFramesAreSpreadEvenly) {
  EXPECT_EQ(spaced_frame(0, 4, 400), 0u);
  EXPECT_EQ(spaced_frame(3, 4, 400), 300u);
  EXPECT_EQ(spaced_frame(2, 3, 3), 2u);
}

}  // namespace
}  // namespace raywalk
