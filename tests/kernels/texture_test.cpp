// Textures against a reference in doubles, their place on surfaces, and what else a material shows without a lamp.
#include "kernels/shade/texture.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "kernels/shade/direct_batch.h"
#include "tests/support/look.h"
#include "tests/support/shaded_scene.h"

namespace raywalk {
namespace {

constexpr float kSpread = 0.1f;  // of a pixel at distance 1

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr Mode kModes[] = {Mode::primary, Mode::shadow, Mode::whitted};

/// A scene of nothing but one image.
class Image {
 public:
  Image(u32 width, u32 height, std::vector<u32> texels) : texels_(std::move(texels)), width_(width), height_(height) {
    test::ShadedScene scene;
    scene.images = {{width, height, texels_}};
    blob_ = test::pack_of(scene);
  }
  static Image random(u32 width, u32 height) {
    test::Random random(width * 100 + height);
    std::vector<u32> texels(size_t{width} * height);
    for (u32& t : texels) t = random.below(1u << 24);
    return {width, height, std::move(texels)};
  }
  Vec3 at(float s, float t) const {
    const SceneView view{blob_.data()};
    return color_of(view, view.textures()[0], {s, t});
  }
  Vec3 texel(u32 x, u32 y) const {
    const u32 value = texels_[y * width_ + x];
    const auto component = [&](u32 shift) { return static_cast<float>(test::srgb_decoded((value >> shift) & 255u)); };
    return {component(0), component(8), component(16)};
  }
  /// Red, green, blue by the definition, in doubles.
  std::array<double, 3> reference(double s, double t) const {
    const auto wrapped = [](double i, u32 count) {
      const double n = count;
      return static_cast<u32>(i - n * std::floor(i / n));
    };
    const double x = s * width_ - 0.5, y = t * height_ - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    std::array<double, 3> sum{};
    for (int corner = 0; corner < 4; ++corner) {
      const double dx = corner & 1, dy = corner >> 1;
      const double weight = (dx ? x - x0 : 1 - (x - x0)) * (dy ? y - y0 : 1 - (y - y0));
      const u32 value = texels_[wrapped(y0 + dy, height_) * width_ + wrapped(x0 + dx, width_)];
      for (u32 k = 0; k < 3; ++k) sum[k] += weight * test::srgb_decoded((value >> 8 * k) & 255u);
    }
    return sum;
  }

 private:
  std::vector<u32> texels_;
  u32 width_, height_;
  Blob blob_;
};

TEST(Texture, IsBilinearInLinearLight) {
  test::Random random(1);
  for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 5u}, {4u, 1u}, {3u, 2u}, {8u, 8u}, {37u, 11u}}) {
    const Image image = Image::random(width, height);
    for (int k = 0; k < 2000; ++k) {
      const float s = random.uniform(-5, 5), t = random.uniform(-5, 5);
      const Vec3 color = image.at(s, t);
      const auto expected = image.reference(s, t);
      for (u32 i = 0; i < 3; ++i) ASSERT_NEAR(color[i], expected[i], 2e-5) << width << "x" << height << " " << s << t;
    }
  }
}

TEST(Texture, CentresAreTheTexelsToTheBit) {
  const Image image = Image::random(8, 4);
  for (u32 y = 0; y < 4; ++y) {
    for (u32 x = 0; x < 8; ++x) {
      const float s = (static_cast<float>(x) + 0.5f) / 8, t = (static_cast<float>(y) + 0.5f) / 4;
      EXPECT_EQ(image.at(s, t), image.texel(x, y));
      EXPECT_EQ(image.at(s - 3, t + 2), image.texel(x, y)) << "repeated";
    }
  }
}

TEST(Texture, HalfwayIsTheMeanAlsoAcrossTheSeam) {
  const Image image = Image::random(4, 1);
  const auto mean = [&](u32 a, u32 b) { return 0.5f * (image.texel(a, 0) + image.texel(b, 0)); };
  EXPECT_LT(test::largest_difference(image.at(0.25f, 0.3f), mean(0, 1)), 1e-7f);
  for (float seam : {0.0f, -0.0f, 1.0f, -2.0f, -1e-30f, 1e-30f, 4194304.0f}) {
    EXPECT_LT(test::largest_difference(image.at(seam, 0.3f), mean(3, 0)), 1e-7f) << seam;
  }
}

TEST(Texture, AnyCoordinateStaysInBounds) {
  test::Random random(2);
  std::vector<float> coordinates = {kNan,       -kNan,       kInf,           -kInf,         kMaxFloat,
                                    -kMaxFloat, 8388607.5f,  -8388607.5f,    1e-45f,        -1e-45f,
                                    -0.0f,      0.99999994f, -5.9604645e-8f, 2147483648.0f, 1.0f};
  for (int k = 0; k < 100000; ++k) coordinates.push_back(float_of(random.below(0xffffffffu)));
  for (u32 count : {1u, 2u, 3u, 1000u, 16384u, 1u << 24}) {
    for (float c : coordinates) {
      const TexelPair pair = texels_around(c, count);
      ASSERT_TRUE(pair.first < count && pair.second < count) << c << " of " << count;
      ASSERT_TRUE(pair.weight >= 0.0f && pair.weight <= 1.0f) << c << " of " << count << ": " << pair.weight;
      ASSERT_EQ(pair.second, (pair.first + 1) % count);
    }
  }
}

/// A unit square in the plane z = 0, upright for who looks along -z, with an image of 2 x 2 texels.
test::ShadedScene poster() {
  test::ShadedScene scene;
  scene.add(test::Quad{{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}, 0);
  scene.images = {{2, 2, {test::texel(255, 0, 0), test::texel(0, 255, 0), test::texel(0, 0, 255), 0xffffffu}}};
  scene.materials = {{.ambient = {1, 1, 1}, .texture = 0}};
  scene.ambient = {1, 1, 1};
  return scene;
}

TEST(Texture, LiesUprightOnASurface) {
  const Blob blob = test::pack_of(poster());
  for (Mode mode : kModes) {
    const auto at = [&](float x, float y) { return test::look(blob, {x, y, 2}, {x, y, 0}, mode); };
    EXPECT_LT(test::largest_difference(at(0.25f, 0.75f), {1, 0, 0}), 1e-6f) << "upper left";
    EXPECT_LT(test::largest_difference(at(0.75f, 0.75f), {0, 1, 0}), 1e-6f) << "upper right";
    EXPECT_LT(test::largest_difference(at(0.25f, 0.25f), {0, 0, 1}), 1e-6f) << "lower left";
    EXPECT_LT(test::largest_difference(at(0.75f, 0.25f), {1, 1, 1}), 1e-6f) << "lower right";
  }
}

TEST(Texture, MultipliesAmbientAndDiffuseAndNothingElse) {
  test::ShadedScene scene = poster();
  scene.images = {{1, 1, {test::texel(255, 0, 255)}}};
  scene.materials = {{.ambient = {0.25f, 0.25f, 0.25f},
                      .diffuse = {0.5f, 0.5f, 0.5f},
                      .specular = {0.5f, 0.5f, 0.5f},
                      .emission = {4, 4, 4},
                      .texture = 0}};
  scene.lights = {{{0.5f, 0.5f, 9}, {1, 1, 1}}};
  const Blob blob = test::pack_of(scene);
  for (Mode mode : kModes)
    EXPECT_LT(test::largest_difference(test::look(blob, {0.5f, 0.5f, 2}, {0.5f, 0.5f, 0}, mode), {5.25f, 4.5f, 5.25f}),
              1e-5f);
}

TEST(Texture, WithoutCoordinatesIsWhite) {
  test::ShadedScene scene = poster();
  scene.texcoords.clear();
  EXPECT_EQ(test::look(test::pack_of(scene), {0.2f, 0.7f, 2}, {0.2f, 0.7f, 0}, Mode::primary), (Vec3{1, 1, 1}));
}

TEST(Texture, BrokenCoordinatesShowSomeTexel) {
  test::ShadedScene scene = poster();
  for (float bad : {kNan, kInf, 1e38f}) {
    for (TexCoord& c : scene.texcoords) c = {bad, -bad};
    const Vec3 color = test::look(test::pack_of(scene), {0.2f, 0.7f, 2}, {0.2f, 0.7f, 0}, Mode::primary);
    EXPECT_TRUE(is_finite(color));
  }
}

TEST(Emission, IsAddedWhateverTheLampsDo) {
  test::ShadedScene scene;
  scene.add(test::Quad{{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}, 0);
  scene.materials = {{.ambient = {0.5f, 0.5f, 0.5f}, .emission = {2, 1, 0.5f}}};
  scene.ambient = {0.5f, 0.25f, 1};
  scene.background = {0.125f, 0, 0};
  const Vec3 expected{2.25f, 1.125f, 1.0f};
  for (u32 lamps : {0u, 1u, 3u}) {
    scene.lights.assign(lamps, {{0.5f, 0.5f, 5}, {1, 1, 1}});
    const Blob blob = test::pack_of(scene);
    SingleTracer<Brute, NoCounter> tracer{SceneView{blob.data()}, nullptr};
    for (Mode mode : kModes) {
      EXPECT_EQ(test::look(blob, {0.3f, 0.4f, 2}, {0.3f, 0.4f, 0}, mode), expected);
      EXPECT_EQ(test::look_with<0>(tracer, blob, test::towards({0.3f, 0.4f, 2}, {0.3f, 0.4f, 0}, mode)), expected);
      EXPECT_EQ(test::look(blob, {3, 3, 2}, {3, 3, 0}, mode), scene.background);
    }
  }
}

TEST(DirectBatch, IsTheSameAsOneByOneWithTextures) {
  // Lanes of one material with texture, of one without, and of both.
  test::ShadedScene scene;
  scene.add(test::quad_grid(4), 0);
  scene.add(test::quad_grid(4, 1, -1.0f), 1);
  scene.add(test::quad_grid(4, 0, 1.0f), 2);
  test::Random random(4);
  for (size_t i = 0; i < 3 * scene.mesh.size(); ++i)
    scene.texcoords.push_back({random.uniform(-2, 2), random.uniform(-2, 2)});
  scene.images = {{test::kPaperWidth, test::kPaperHeight, {test::kPaper.begin(), test::kPaper.end()}},
                  {1, 2, {test::texel(9, 99, 199), test::texel(200, 100, 50)}}};
  const Material plain{.ambient = {0.1f, 0.2f, 0.3f},
                       .diffuse = {0.6f, 0.7f, 0.8f},
                       .specular = {0.3f, 0.3f, 0.3f},
                       .emission = {0.01f, 0, 0.02f},
                       .shininess = 20};
  scene.materials = {plain, plain, plain};
  scene.materials[1].texture = 0;
  scene.materials[2].texture = 1;
  scene.lights = {{{3, 3, 3}, {0.5f, 0.5f, 0.5f}}, {{-3, 3, 3}, {0.25f, 0.5f, 0.5f}}};
  scene.ambient = {0.5f, 0.5f, 0.5f};
  const Blob blob = test::pack_of(scene);
  const SceneView view{blob.data()};
  for (int k = 0; k < 300; ++k) {
    HitBatch batch;
    for (u32 i = 0; i < kBatch; ++i) {
      const u32 first = k % 4 == 3 ? 0 : static_cast<u32>(k % 4) * 32, count = k % 4 == 3 ? 96 : 32;
      batch.id[i] = first + random.below(count);
      batch.t[i] = 4.0f * random.uniform();
      batch.u[i] = random.uniform();
      batch.v[i] = random.uniform() * (1.0f - batch.u[i]);
      batch.d.set(i, random.direction());
    }
    Vec3Batch colors;
    unshadowed_batch(view, batch, kSpread, view.light_count(), colors);
    for (u32 i = 0; i < kBatch; ++i) {
      const Hit hit{batch.t[i], batch.id[i], batch.u[i], batch.v[i]};
      ASSERT_EQ(colors.get(i), unshadowed<kAllFeatures>(view, hit, batch.d.get(i), kSpread, view.light_count()));
    }
  }
}

TEST(Texture, FarAwayTheSmallerImagesAreSeen) {
  // One unit square with an image of 8 x 8 texels, its levels told apart by their colour.
  test::ShadedScene scene;
  scene.add(test::quad_grid(1, 2, 0.0f, 0.0f, 1.0f), 0);
  scene.materials = {{.diffuse = {1, 1, 1}, .texture = 0}};
  const auto one = [](u32 side, u32 grey, u32 levels) {
    return test::ShadedScene::Image{side, side, std::vector<u32>(size_t{side} * side, test::texel(grey, grey, grey)),
                                    levels};
  };
  scene.images = {one(8, 0, 4), one(4, 80, 3), one(2, 160, 2), one(1, 240, 1)};
  const auto& mesh = scene.mesh;
  for (const Corners& t : mesh)
    for (const Vec3 p : {t.a, t.b, t.c}) scene.texcoords.push_back({p.x, p.y});
  const Blob blob = test::pack_of(scene);
  const SceneView view{blob.data()};
  const auto level_at = [&](Vec3 d, float width) {
    const float seen = tint_at(view, view.corners()[0], view.triangles()[0], 0.25f, 0.25f, d, width).x;
    for (u32 level = 0; level < 4; ++level)
      if (seen == static_cast<float>(test::srgb_decoded(80 * level))) return static_cast<int>(level);
    return -1;
  };
  const Vec3 normal = normalized(cross(mesh[0].b - mesh[0].a, mesh[0].c - mesh[0].a));
  const float texel = 0.125f;  // its width
  EXPECT_EQ(level_at(normal, 0.0f), 0);
  EXPECT_EQ(level_at(normal, texel), 0);
  EXPECT_EQ(level_at(-normal, 2 * texel), 1);
  EXPECT_EQ(level_at(normal, 4 * texel), 2);
  EXPECT_EQ(level_at(normal, 8 * texel), 3);
  EXPECT_EQ(level_at(normal, 1e30f), 3);
  EXPECT_EQ(level_at(normal, std::numeric_limits<float>::quiet_NaN()), 0);
  // At a slant a pixel covers more: by 1 / cosine.
  const Vec3 along = normalized(mesh[0].b - mesh[0].a);
  const Vec3 slant = normalized(normal + 15.97f * along);
  EXPECT_EQ(level_at(slant, texel), 2);
  // In the plane of the triangle itself.
  EXPECT_EQ(level_at(along, texel), 3);
}

}  // namespace
}  // namespace raywalk
