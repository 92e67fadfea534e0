// Smaller versions of textures: means in linear light, odd sides, and their place in the kernel blob.
#include "server/scene/mip_levels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raywalk::test {
namespace {

Texture grey(u32 width, u32 height, const std::vector<u32>& components) {
  Texture texture{"t", width, height, {}};
  for (const u32 c : components) texture.texels.push_back(c | c << 8 | c << 16);
  return texture;
}

TEST(MipLevels, halve_down_to_one_texel) {
  const std::vector<Texture> levels = mip_levels(grey(5, 2, std::vector<u32>(10, 77)));
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].width, 2u);
  EXPECT_EQ(levels[0].height, 1u);
  EXPECT_EQ(levels[1].width, 1u);
  for (const Texture& level : levels) {
    for (const u32 texel : level.texels) EXPECT_EQ(texel, 77u | 77u << 8 | 77u << 16);
  }
  EXPECT_TRUE(mip_levels(grey(1, 1, {3})).empty());
  for (const auto& [width, height] : {std::pair{1u, 1u}, {5u, 2u}, {1u, 9u}, {64u, 33u}}) {
    const std::vector<Texture> all = mip_levels(grey(width, height, std::vector<u32>(width * height, 9)));
    u64 texels = 0;
    for (const Texture& level : all) texels += level.texels.size();
    EXPECT_EQ(mip_counts(width, height).levels, all.size());
    EXPECT_EQ(mip_counts(width, height).texels, texels);
  }
}

TEST(MipLevels, mean_is_taken_in_linear_light) {
  // Half white, half black is sRGB 188, not 128.
  EXPECT_EQ(mip_levels(grey(2, 2, {255, 0, 0, 255}))[0].texels[0] & 255u, 188u);
  EXPECT_EQ(mip_levels(grey(1, 2, {255, 0}))[0].texels[0] & 255u, 188u);
  // Every component survives being the mean of itself.
  for (u32 c = 0; c < 256; ++c) EXPECT_EQ(mip_levels(grey(2, 1, {c, c}))[0].texels[0] & 255u, c);
}

TEST(MipLevels, lie_behind_their_image_in_the_blob) {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.texcoords.resize(3);
  scene.triangles = {{0, 1, 2, 0}};
  scene.textures = {grey(4, 4, std::vector<u32>(16, 200)), grey(2, 2, {255, 0, 0, 255})};
  scene.materials.resize(2);
  scene.materials[0].texture = 1;
  const Blob blob = pack(scene);
  const SceneView view{blob.data()};
  ASSERT_EQ(view.header().textures.count, 5u);
  ASSERT_EQ(view.header().texels.count, 16u + 4u + 1u + 4u + 1u);
  EXPECT_EQ(view.materials()[0].texture, 3u);
  EXPECT_EQ(view.materials()[1].texture, kNoTexture);
  const u32 levels[] = {3, 2, 1, 2, 1};
  for (u32 i = 0; i < 5; ++i) EXPECT_EQ(view.textures()[i].levels, levels[i]);
  EXPECT_EQ(view.texels()[view.textures()[4].first_texel] & 255u, 188u);
}

}  // namespace
}  // namespace raywalk::test
