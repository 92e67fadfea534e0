// Image metrics: values that the definitions give, borders, what is no number, and the figures of the FLIP authors'
// own implementation.
#include "server/image/metrics.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "server/image/decode_texture.h"
#include "server/image/srgb.h"

namespace raywalk {
namespace {

constexpr double kBlackAgainstWhite = 0.96739;  // FLIP's largest error of grey values

/// The inverse of srgb_encoded.
float linear_of(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Frame uniform(u32 width, u32 height, float linear) {
  Frame frame{.width = width, .height = height, .channels = 3, .pixels = {}};
  frame.pixels.assign(std::size_t{3} * width * height, linear);
  return frame;
}

Frame noise(u32 width, u32 height, u32 seed) {
  Frame frame = uniform(width, height, 0);
  std::mt19937 random(seed);
  for (float& value : frame.pixels) value = static_cast<float>(random() % 4096) / 4096.0f;
  return frame;
}

void paint(Frame& frame, u32 x, u32 y, Vec3 rgb) {
  for (u32 c = 0; c < 3; ++c) frame.pixels[3 * (std::size_t{y} * frame.width + x) + c] = rgb[c];
}

std::string read(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(std::filesystem::path(RAYWALK_PICTURES_DIR) / name, std::ios::binary).rdbuf();
  return text.str();
}

Frame picture(const std::string& name) {
  const std::string bytes = read(name);
  const Texture texture = decode_texture({reinterpret_cast<const u8*>(bytes.data()), bytes.size()});
  Frame frame = uniform(texture.width, texture.height, 0);
  for (std::size_t i = 0; i < texture.texels.size(); ++i) {
    for (u32 c = 0; c < 3; ++c) {
      frame.pixels[3 * i + c] = linear_of(static_cast<float>(texture.texels[i] >> (8 * c) & 255) / 255.0f);
    }
  }
  return frame;
}

void expect_no_difference(const ImageMetrics& m) {
  EXPECT_EQ(m.changed_pixels, 0u);
  EXPECT_EQ(m.rmse(), 0.0);
  EXPECT_FALSE(m.psnr_db().has_value());
  EXPECT_EQ(m.ssim, 1.0);
  EXPECT_EQ(m.flip_mean, 0.0);
  EXPECT_EQ(m.flip_p99, 0.0);
  EXPECT_EQ(m.flip_max, 0.0);
}

TEST(ImageMetrics, OfIdenticalPictures) {
  Frame a = noise(40, 30, 1);
  a.pixels[7] = std::numeric_limits<float>::quiet_NaN();
  const ImageMetrics m = compare_pictures(a, a);
  EXPECT_EQ(m.pixels, 1200u);
  expect_no_difference(m);
}

TEST(ImageMetrics, OfPicturesThatAreShownAlike) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Frame a = noise(30, 20, 2), b = a;
  paint(a, 3, 4, {nan, kInfinity, -kInfinity});
  paint(b, 3, 4, {0, 1, 0});
  paint(a, 9, 9, {-2, 7, -nan});
  paint(b, 9, 9, {-1e-9f, 1.5f, -0.0f});
  expect_no_difference(compare_pictures(a, b));
}

TEST(ImageMetrics, WhatIsNoNumberIsShownBlack) {
  const ImageMetrics m = compare_pictures(uniform(9, 9, std::numeric_limits<float>::quiet_NaN()), uniform(9, 9, 1.0f));
  EXPECT_EQ(m.rmse(), 1.0);
  EXPECT_NEAR(m.flip_mean, kBlackAgainstWhite, 1e-4);
}

TEST(ImageMetrics, OfBlackAgainstWhite) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 7u}, {7u, 1u}, {3u, 2u}, {70u, 130u}}) {
    const ImageMetrics m = compare_pictures(uniform(width, height, 0), uniform(width, height, 1));
    EXPECT_EQ(m.changed_pixels, m.pixels);
    EXPECT_EQ(m.rmse(), 1.0);
    EXPECT_EQ(m.psnr_db(), 0.0);
    EXPECT_NEAR(m.ssim, 1e-4 / (1 + 1e-4), 1e-6);
    EXPECT_NEAR(m.flip_mean, kBlackAgainstWhite, 1e-4) << width << "x" << height;
    EXPECT_NEAR(m.flip_p99, kBlackAgainstWhite, 1e-4);
    EXPECT_NEAR(m.flip_max, kBlackAgainstWhite, 1e-4);
  }
}

TEST(ImageMetrics, GreenAgainstBlueIsTheLargestError) {
  Frame green = uniform(20, 20, 0), blue = green;
  for (u32 i = 0; i < 400; ++i) {
    paint(green, i % 20, i / 20, {0, 1, 0});
    paint(blue, i % 20, i / 20, {0, 0, 1});
  }
  EXPECT_NEAR(compare_pictures(green, blue).flip_mean, 1.0, 1e-5);
}

TEST(ImageMetrics, OfAConstantOffset) {
  const double a = 100.0 / 255, b = 110.0 / 255;
  const ImageMetrics m =
      compare_pictures(uniform(33, 21, linear_of(100.0f / 255)), uniform(33, 21, linear_of(110.0f / 255)));
  EXPECT_EQ(m.changed_pixels, 33u * 21u);
  EXPECT_NEAR(m.rmse(), 10.0 / 255, 1e-6);
  EXPECT_NEAR(*m.psnr_db(), 28.1308, 1e-3);
  EXPECT_NEAR(m.ssim, (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-5);
  EXPECT_NEAR(m.flip_mean, m.flip_max, 1e-5);
}

TEST(ImageMetrics, LessThanALevelChangesNoPixel) {
  const ImageMetrics m =
      compare_pictures(uniform(8, 8, linear_of(100.0f / 255)), uniform(8, 8, linear_of(100.3f / 255)));
  EXPECT_EQ(m.changed_pixels, 0u);
  EXPECT_NEAR(m.rmse(), 0.3 / 255, 1e-6);
}

TEST(ImageMetrics, OfASinglePixelWhereverItIs) {
  const Frame grey = uniform(256, 256, 0.2f);
  double flip_mean = 0, ssim = 0;
  for (const u32 y : {30u, 63u, 64u, 68u, 130u, 150u}) {  // strips of rows are computed apart
    Frame other = grey;
    paint(other, 100, y, {1, 0, 0});
    const ImageMetrics m = compare_pictures(grey, other);
    EXPECT_EQ(m.changed_pixels, 1u);
    EXPECT_NEAR(m.flip_max, 0.23841, 1e-4);  // as flip-evaluator has it
    EXPECT_EQ(m.flip_p99, 0.0) << "21 x 21 pixels at most are less than a hundredth";
    EXPECT_LT(m.flip_mean, 441.0 / 65536);
    if (y == 30) {
      flip_mean = m.flip_mean;
      ssim = m.ssim;
    }
    EXPECT_LT(m.ssim, 1.0);
    EXPECT_NEAR(m.ssim, ssim, 1e-9);
    EXPECT_NEAR(m.flip_mean, flip_mean, 1e-9);
  }
}

TEST(ImageMetrics, DoNotDependOnThreads) {
  const Frame a = noise(150, 210, 3), b = noise(150, 210, 4);
  const ImageMetrics many = compare_pictures(a, b);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const ImageMetrics one = compare_pictures(a, b);
  EXPECT_EQ(one.changed_pixels, many.changed_pixels);
  EXPECT_EQ(one.squared_error, many.squared_error);
  EXPECT_EQ(one.ssim, many.ssim);
  EXPECT_EQ(one.flip_mean, many.flip_mean);
  EXPECT_EQ(one.flip_p99, many.flip_p99);
  EXPECT_EQ(one.flip_max, many.flip_max);
}

TEST(ImageMetrics, SizesMustAgree) {
  EXPECT_THROW(compare_pictures(noise(4, 6, 5), noise(6, 4, 5)), std::logic_error);
  EXPECT_THROW(compare_pictures(uniform(0, 0, 0), uniform(0, 0, 0)), std::logic_error);
  Frame depth = uniform(4, 4, 0);
  depth.pixels.resize(16);
  EXPECT_THROW(compare_pictures(depth, depth), std::logic_error);
}

/// metrics.json holds what the client computes of the same files (tests/client/test_compare_images.py checks it): FLIP
/// by the package flip-evaluator, the rest with numpy.
TEST(ImageMetrics, AgreeWithTheClient) {
  const auto expected = nlohmann::json::parse(read("metrics.json"));
  const ImageMetrics m = compare_pictures(picture("room.png"), picture("room_next.png"));
  EXPECT_EQ(m.pixels, expected.at("pixels"));
  EXPECT_EQ(m.changed_pixels, expected.at("changed_pixels"));
  EXPECT_NEAR(m.rmse(), expected.at("rmse").get<double>(), 1e-6);
  EXPECT_NEAR(*m.psnr_db(), expected.at("psnr_db").get<double>(), 1e-3);
  EXPECT_NEAR(m.ssim, expected.at("ssim").get<double>(), 1e-5);
  EXPECT_NEAR(m.flip_mean, expected.at("flip_mean").get<double>(), 1e-5);
  EXPECT_NEAR(m.flip_p99, expected.at("flip_p99").get<double>(), 1e-4);
  EXPECT_NEAR(m.flip_max, expected.at("flip_max").get<double>(), 1e-4);
}

}  // namespace
}  // namespace raywalk
