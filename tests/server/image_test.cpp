// Transfer function, viewable colours, encoders.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "server/image/encode.h"
#include "server/image/jpeg_strips.h"
#include "server/image/srgb.h"
#include "server/image/viewable.h"

namespace raywalk {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Frame frame_of(u32 channels, std::vector<float> pixels) {
  const auto count = static_cast<u32>(pixels.size()) / channels;
  return {count, 1, channels, std::move(pixels), 0, 0};
}

TEST(Srgb, KnownValues) {
  EXPECT_FLOAT_EQ(srgb_encoded(0.0f), 0.0f);
  EXPECT_NEAR(srgb_encoded(1.0f), 1.0f, 1e-6f);
  EXPECT_NEAR(srgb_encoded(0.5f), 0.7353569f, 1e-6f);
  EXPECT_NEAR(srgb_encoded(0.002f), 0.02584f, 1e-6f);
  EXPECT_FLOAT_EQ(srgb_encoded(-3.0f), 0.0f);
  EXPECT_NEAR(srgb_encoded(kInfinity), 1.0f, 1e-6f);
}

TEST(Srgb, TableIsTheRoundedFunction) {
  std::vector<float> linear;
  for (int i = 0; i <= 100'000; ++i) linear.push_back(static_cast<float>(i) * 1e-5f);
  std::vector<u8> bytes(linear.size());
  srgb_bytes(linear, bytes.data());
  for (std::size_t i = 0; i < linear.size(); ++i) {
    EXPECT_NEAR(bytes[i], 255.0f * srgb_encoded(linear[i]), 0.61f) << linear[i];
  }
  const float odd[] = {kNan, -1.0f, kInfinity, -kInfinity};
  u8 out[4];
  srgb_bytes(odd, out);
  EXPECT_EQ((std::vector<u8>{out, out + 4}), (std::vector<u8>{0, 0, 255, 0}));
}

TEST(Viewable, DepthIsBrightNearAndBlackAtAMiss) {
  const std::vector<u8> v = viewable(frame_of(1, {1, 2, kInfinity, kMaxFloat}), Output::depth);
  ASSERT_EQ(v.size(), 12u);
  EXPECT_GT(v[0], v[3]);
  EXPECT_GT(v[3], 0);
  EXPECT_EQ(v[6], 0);
  EXPECT_EQ(v[9], 0);
}

TEST(Viewable, IdsDifferAndMissesAreBlack) {
  const std::vector<u8> v = viewable(frame_of(1, {0, 1, -1}), Output::id);
  EXPECT_NE(std::vector<u8>(v.begin(), v.begin() + 3), std::vector<u8>(v.begin() + 3, v.begin() + 6));
  EXPECT_EQ(std::vector<u8>(v.begin() + 6, v.end()), std::vector<u8>(3, 0));
}

TEST(Viewable, EmptyViewsDoNotDivideByZero) {
  EXPECT_EQ(viewable(frame_of(1, {kInfinity, kInfinity}), Output::depth), std::vector<u8>(6, 0));
  EXPECT_EQ(viewable(frame_of(2, {0, 0, 0, 0}), Output::steps).size(), 6u);
}

TEST(Encode, EveryFormatHasItsMagic) {
  Frame frame{33, 17, 3, std::vector<float>(33 * 17 * 3, 0.25f), 0, 0};
  EXPECT_EQ(encode(frame, Output::color, ImageFormat::jpeg).substr(0, 3), "\xff\xd8\xff");
  EXPECT_EQ(encode(frame, Output::color, ImageFormat::png).substr(1, 3), "PNG");
  EXPECT_EQ(encode(frame, Output::color, ImageFormat::exr).substr(0, 4), "\x76\x2f\x31\x01");
  const std::string raw = encode(frame, Output::color, ImageFormat::raw);
  ASSERT_EQ(raw.size(), frame.pixels.size() * sizeof(float));
  EXPECT_EQ(std::memcmp(raw.data(), frame.pixels.data(), raw.size()), 0);
}

TEST(JpegStrips, BecomeRestartIntervalsOfOneImage) {
  const Frame tall{40, 3 * kJpegStripRows + 5, 3, std::vector<float>(std::size_t{40} * 197 * 3, 0.25f), 0, 0};
  const std::string jpeg = encode(tall, Output::color, ImageFormat::jpeg);
  const auto count = [&](const std::string& marker) {
    std::size_t found = 0;
    for (std::size_t at = jpeg.find(marker); at != std::string::npos; at = jpeg.find(marker, at + 2)) ++found;
    return found;
  };
  EXPECT_EQ(count("\xff\xd8"), 1u);
  EXPECT_EQ(count("\xff\xd9"), 1u);
  // 40 pixels are 3 blocks of 16, a strip has 4 rows of them.
  EXPECT_EQ(count(std::string("\xff\xdd\x00\x04\x00\x0c", 6)), 1u);
  for (const char* restart : {"\xff\xd0", "\xff\xd1", "\xff\xd2"}) EXPECT_EQ(count(restart), 1u);
  EXPECT_EQ(count("\xff\xd3"), 0u);
}

TEST(JpegStrips, WhatIsNoJpegIsRefused) {
  const std::string whole = encode({16, 16, 3, std::vector<float>(768, 0.5f), 0, 0}, Output::color, ImageFormat::jpeg);
  EXPECT_THROW(join_jpeg_strips({"", ""}, 80), std::runtime_error);
  EXPECT_THROW(join_jpeg_strips({whole.substr(0, 40), whole}, 80), std::runtime_error);
  EXPECT_THROW(join_jpeg_strips({whole, whole.substr(2)}, 80), std::runtime_error);
}

TEST(Encode, OnePixelAndFewChannels) {
  for (const auto& [output, channels] : {std::pair{Output::depth, 1u}, {Output::steps, 2u}, {Output::normal, 3u}}) {
    Frame frame{1, 1, channels, std::vector<float>(channels, 1.0f), 0, 0};
    for (const ImageFormat format : {ImageFormat::jpeg, ImageFormat::png, ImageFormat::exr, ImageFormat::raw}) {
      EXPECT_FALSE(encode(frame, output, format).empty());
    }
  }
}

}  // namespace
}  // namespace raywalk
