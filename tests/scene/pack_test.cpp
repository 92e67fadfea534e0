// Packing into the kernel blob, features, hashes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernels/features.h"
#include "server/scene/scene.h"
#include "server/system/sha256.h"

namespace raywalk::test {
namespace {

Scene two_triangles() {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 9}};
  scene.triangles = {{0, 1, 2, 0}, {0, 1, 3, 1}};
  scene.materials = {default_material(), default_material()};
  scene.lights = {{{0, 0, 5}, {1, 1, 1}}};
  return scene;
}

TEST(Pack, lays_out_everything) {
  Scene scene = two_triangles();
  scene.background = {0.1f, 0.2f, 0.3f};
  const Blob blob = pack(scene);
  const SceneView view{blob.data()};
  ASSERT_EQ(view.triangle_count(), 2u);
  EXPECT_EQ(view.corners()[1].c, (Vec3{0, 0, 9}));
  EXPECT_EQ(view.corners()[1].id, 1u);
  EXPECT_EQ(view.triangles()[1].material, 1u);
  EXPECT_EQ(view.header().bounds.hi, (Vec3{1, 2, 9}));
  EXPECT_EQ(view.header().background, scene.background);
  EXPECT_EQ(view.light_count(), 1u);
  EXPECT_EQ(view.header().normals.count, 0u);
}

TEST(Pack, leaves_out_of_the_bounds_what_is_not_finite) {
  Scene scene = two_triangles();
  scene.positions[3].x = std::numeric_limits<float>::quiet_NaN();
  const Blob blob = pack(scene);
  EXPECT_EQ(blob.header<SceneHeader>().bounds.hi, (Vec3{1, 2, 0}));
  EXPECT_EQ(blob.header<SceneHeader>().corners.count, 2u);
}

TEST(Pack, takes_away_triangles_without_an_area) {
  const auto taken = [](Vec3 a, Vec3 b, Vec3 c) {
    Scene scene = two_triangles();
    scene.positions = {a, b, c, {0, 0, 9}};
    scene.triangles = {{0, 1, 2, 0}};
    const Blob blob = pack(scene);
    const Corners& corners = SceneView{blob.data()}.corners()[0];
    EXPECT_EQ(corners.id, 0u);
    EXPECT_EQ(is_finite(corners), !blob.header<SceneHeader>().bounds.empty());
    return !is_finite(corners);
  };
  EXPECT_TRUE(taken({1, 2, 3}, {1, 2, 3}, {1, 2, 3}));
  EXPECT_TRUE(taken({1, 2, 3}, {1, 2, 3}, {4, 0, 1}));
  EXPECT_TRUE(taken({0, 2, 2}, {0, 3, 3}, {0, 0, 0}));
  EXPECT_TRUE(taken({0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 0.2f}, {0.4f, 0.4f, 0.4f}));
  EXPECT_TRUE(taken({1e30f, 0, 0}, {2e30f, 0, 0}, {3e30f, 0, 0}));
  EXPECT_TRUE(taken({1e6f, 1e6f, 0}, {1e6f + 1, 1e6f + 1, 1e-3f}, {1e6f + 2, 1e6f + 2, 2e-3f}));
  // One ulp beside the line, and slivers.
  EXPECT_FALSE(taken({0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, std::nextafter(0.2f, 1.0f)}, {0.4f, 0.4f, 0.4f}));
  EXPECT_FALSE(taken({0, 0, 0}, {1e6f, 0, 0}, {5e5f, 1e-6f, 0}));
  EXPECT_FALSE(taken({1e6f, 1e6f, 0}, {1e6f + 1, 1e6f + 1, 1e-20f}, {1e6f + 2, 1e6f + 2, 3e-20f}));
  EXPECT_FALSE(taken({0, 0, 0}, {1e-30f, 0, 0}, {0, 1e-30f, 0}));
}

TEST(Pack, refuses_indices_out_of_range) {
  Scene scene = two_triangles();
  scene.triangles[1].c = 4;
  EXPECT_THROW(pack(scene), std::invalid_argument);
  scene = two_triangles();
  scene.triangles[0].material = 2;
  EXPECT_THROW(pack(scene), std::invalid_argument);
  scene = two_triangles();
  scene.normals.resize(3);
  EXPECT_THROW(pack(scene), std::invalid_argument);
}

TEST(Pack, features_follow_the_scene) {
  Scene scene = two_triangles();
  for (Material& m : scene.materials) m.specular = {};
  EXPECT_EQ(features_of(scene), 0u);
  scene.materials[1].reflection.y = 0.1f;
  EXPECT_EQ(features_of(scene), static_cast<u32>(kFeatureReflection));
  scene.normals.resize(4);
  scene.lights.resize(2);
  scene.materials[0].transmission.x = scene.materials[0].specular.z = 1.0f;
  EXPECT_EQ(features_of(scene), kAllFeatures & ~kFeatureTextures);
  scene.materials[0].texture = 0;
  EXPECT_EQ(features_of(scene), kAllFeatures);
}

TEST(Sha256, known_answers) {
  const auto hash = [](const std::string& text) {
    Sha256 h;
    h.add(text.data(), text.size());
    return h.hex();
  };
  EXPECT_EQ(hash(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hash("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hash(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  Sha256 pieces;
  for (int i = 0; i < 1'000'000; i += 125) pieces.add(std::string(125, 'a').data(), 125);
  EXPECT_EQ(pieces.hex(), hash(std::string(1'000'000, 'a')));
}

}  // namespace
}  // namespace raywalk::test
