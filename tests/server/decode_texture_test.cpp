// Image files into textures: formats, channels, depths, and what is refused.
#include "server/image/decode_texture.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "server/image/encode.h"
#include "server/image/srgb.h"

namespace raywalk {
namespace {

using Texels = std::vector<u32>;

constexpr u32 rgb(u32 r, u32 g, u32 b) {
  return r | g << 8 | b << 16;
}

Texture decode(const std::string& bytes) {
  return decode_texture({reinterpret_cast<const u8*>(bytes.data()), bytes.size()});
}

std::string bytes_of(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += static_cast<char>(value);
  return bytes;
}

std::string from_hex(const std::string& hex) {
  std::string bytes;
  for (size_t i = 0; i < hex.size(); i += 2) bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

/// The message of the refusal; empty if there is none.
std::string refusal(const std::string& bytes) {
  try {
    decode(bytes);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

std::string encoded(ImageFormat format, u32 width, u32 height, Vec3 linear) {
  Frame frame{width, height, 3, {}, 0, 0};
  for (u32 i = 0; i < width * height; ++i) frame.pixels.insert(frame.pixels.end(), {linear.x, linear.y, linear.z});
  return encode(frame, Output::color, format);
}

TEST(DecodeTexture, PpmRowsTopDownAndRedLowest) {
  const Texture t = decode("P6\n# a comment\n2 2\n255\n" + bytes_of({1, 2, 3, 4, 5, 6, 7, 8, 9, 250, 251, 252}));
  EXPECT_EQ(t.width, 2u);
  EXPECT_EQ(t.height, 2u);
  EXPECT_EQ(t.texels, (Texels{rgb(1, 2, 3), rgb(4, 5, 6), rgb(7, 8, 9), rgb(250, 251, 252)}));
  EXPECT_TRUE(t.name.empty());
}

TEST(DecodeTexture, BytesAfterThePpmAreIgnored) {
  EXPECT_EQ(decode("P6 1 1 255\n" + bytes_of({9, 8, 7, 10})).texels, Texels{rgb(9, 8, 7)});
}

TEST(DecodeTexture, GreyBecomesRgb) {
  EXPECT_EQ(decode("P5 2 1 255\n" + bytes_of({0, 77})).texels, (Texels{0, rgb(77, 77, 77)}));
  EXPECT_EQ(decode("P2 2 1 255\n3 200\n").texels, (Texels{rgb(3, 3, 3), rgb(200, 200, 200)}));
}

TEST(DecodeTexture, SixteenBits) {
  EXPECT_EQ(decode("P5 2 1 65535\n" + bytes_of({0xff, 0xff, 0x80, 0x80})).texels,
            (Texels{rgb(255, 255, 255), rgb(128, 128, 128)}));
  const std::string png = from_hex(
      "89504e470d0a1a0a0000000d4948445200000001000000011002000000c0e78f9d0000000f4944415478da63f8ffbfa18181"
      "01000e7c02ff3e79fa030000000049454e44ae426082");
  EXPECT_EQ(decode(png).texels, Texels{rgb(255, 128, 0)});
}

TEST(DecodeTexture, AlphaIsDroppedAndColoursAreNotMultiplied) {
  const std::string png = from_hex(
      "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a000000114944415478da63389162c4c025"
      "22f71f000bd0029a649ef0210000000049454e44ae426082");
  EXPECT_EQ(decode(png).texels, (Texels{rgb(200, 100, 50), rgb(10, 20, 30)}));
  // TGA, 32 bits, rows top down, blue first.
  const std::string tga =
      bytes_of({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 32, 0x28}) + bytes_of({3, 2, 1, 128, 6, 5, 4, 255});
  EXPECT_EQ(decode(tga).texels, (Texels{rgb(1, 2, 3), rgb(4, 5, 6)}));
}

TEST(DecodeTexture, TgaAndBmpRowsBottomUp) {
  const std::string tga =
      bytes_of({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 24, 0}) + bytes_of({3, 2, 1, 6, 5, 4});
  EXPECT_EQ(decode(tga).texels, (Texels{rgb(4, 5, 6), rgb(1, 2, 3)}));
  const std::string bmp = "BM" + bytes_of({62, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0}) +
                          bytes_of({40, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 1, 0, 24, 0, 0, 0, 0, 0}) +
                          bytes_of({8, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) +
                          bytes_of({3, 2, 1, 0, 6, 5, 4, 0});
  EXPECT_EQ(decode(bmp).texels, (Texels{rgb(4, 5, 6), rgb(1, 2, 3)}));
}

TEST(DecodeTexture, JpegAndPng) {
  const Texture png = decode(encoded(ImageFormat::png, 5, 3, {1, 0, 0}));
  EXPECT_EQ(png.texels, Texels(15, rgb(255, 0, 0)));
  const Texture jpeg = decode(encoded(ImageFormat::jpeg, 40, 24, {1, 1, 1}));
  EXPECT_EQ(jpeg.width, 40u);
  EXPECT_EQ(jpeg.height, 24u);
  EXPECT_EQ(jpeg.texels, Texels(40 * 24, rgb(255, 255, 255)));
}

TEST(DecodeTexture, FloatsAreEncoded) {
  const u32 half = static_cast<u32>(255.0f * srgb_encoded(0.5f) + 0.5f);
  EXPECT_EQ(decode(encoded(ImageFormat::exr, 3, 2, {0.5f, 0, 7})).texels, Texels(6, rgb(half, 0, 255)));
  // 0.5 is 128 / 256 at exponent 128.
  const std::string hdr =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + bytes_of({128, 0, 255, 128, 0, 0, 0, 0});
  const Texture t = decode(hdr);
  ASSERT_EQ(t.texels.size(), 2u);
  EXPECT_NEAR(t.texels[0] & 255, half, 1);
  EXPECT_EQ(t.texels[1], 0u);
}

TEST(DecodeTexture, WhatIsNoImage) {
  EXPECT_EQ(refusal(""), "not an image of a known format");
  EXPECT_EQ(refusal("P9 1 1 255\nabc"), "not an image of a known format");
  EXPECT_EQ(refusal("<html>no such page, at great length</html>"), "not an image of a known format");
}

TEST(DecodeTexture, CutShort) {
  EXPECT_NE(refusal("P6 2 2 255\nabc"), "");
  EXPECT_NE(refusal("P6 2"), "");
  const std::string png = encoded(ImageFormat::png, 16, 16, {1, 0.5f, 0});
  EXPECT_NE(refusal(png.substr(0, 40)), "");
  EXPECT_NE(refusal(encoded(ImageFormat::exr, 16, 16, {1, 1, 1}).substr(0, 100)), "");
}

TEST(DecodeTexture, LyingSizes) {
  EXPECT_EQ(refusal("P6 16385 1 255\nabc"), "16385 x 1 texels; the most is 16384 a side");
  EXPECT_EQ(refusal("P6 16384 16384 255\nabc"), "a file of 22 bytes does not hold 16384 x 16384 texels");
  EXPECT_NE(refusal("P6 0 4 255\nabc"), "");
  EXPECT_NE(refusal("P6 -3 4 255\nabc"), "");
}

TEST(DecodeTexture, OriginalSceneData) {
  const char* data = std::getenv("RAYWALK_SCENE_DATA");
  if (data == nullptr) GTEST_SKIP() << "RAYWALK_SCENE_DATA names no folder of original scene data";
  u32 images = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data)) {
    if (entry.path().extension() != ".ppm") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    const Texture t = decode({std::istreambuf_iterator<char>(file), {}});
    EXPECT_EQ(t.texels.size(), u64{t.width} * t.height) << entry.path();
    ++images;
  }
  if (images == 0) GTEST_SKIP() << "no PPM files in " << data;
}

}  // namespace
}  // namespace raywalk
