// glTF materials and their images as Phong's and Whitted's; the original files.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "server/scene/importer.h"
#include "tests/scene/files.h"
#include "tests/scene/gltf_file.h"

namespace raywalk {
namespace {

using test::Folder;
using test::GltfFile;
using test::message_of;

/// One texel, of the first three bytes.
Texture first_bytes(std::span<const u8> bytes) {
  if (bytes.size() < 3) throw std::runtime_error("too short");
  return {"", 1, 1, {static_cast<u32>(bytes[0] | bytes[1] << 8 | bytes[2] << 16)}};
}

/// A triangle with texture coordinates in both sets and the material.
GltfFile with_material(const std::string& material) {
  GltfFile file;
  file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  file.add_floats({0, 0, 1, 0, 0, 1}, "VEC2");
  file.add_floats({0.5f, 0.5f, 0.25f, 0, 0, 0.75f}, "VEC2");
  file.set("meshes",
           R"([{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}, "material": 0}]}])");
  file.set("nodes", R"([{"mesh": 0}])");
  file.set("materials", "[" + material + "]");
  return file;
}

Scene load(const GltfFile& file) {
  const Folder folder;
  return load_mesh(file.write_gltf(folder), {.decode = first_bytes});
}

Material material_of(const std::string& json) {
  return load(with_material(json)).materials.at(0);
}

void expect_near(Vec3 a, Vec3 b) {
  EXPECT_NEAR(a.x, b.x, 1e-6f);
  EXPECT_NEAR(a.y, b.y, 1e-6f);
  EXPECT_NEAR(a.z, b.z, 1e-6f);
}

bool is_black(Vec3 colour) {
  return colour == Vec3{0, 0, 0};
}

TEST(GltfMaterial, RoughPlasticIsDiffuse) {
  const Material m = material_of(
      R"({"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.4, 0.2, 1], "metallicFactor": 0, "roughnessFactor": 1}})");
  expect_near(m.diffuse, {0.8f, 0.4f, 0.2f});
  expect_near(m.ambient, m.diffuse);
  EXPECT_TRUE(is_black(m.specular) && is_black(m.reflection) && is_black(m.transmission) && is_black(m.emission));
  EXPECT_EQ(m.texture, kNoTexture);
  EXPECT_EQ(m.ior, 1.0f);
}

TEST(GltfMaterial, MetalMirrorsWhereItIsSmooth) {
  const char* metal = R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.8, 0.4, 1], "roughnessFactor": )";
  const Material polished = material_of(metal + std::string("0}}")), rough = material_of(metal + std::string("0.9}}"));
  expect_near(polished.reflection, {1, 0.8f, 0.4f});
  EXPECT_TRUE(is_black(polished.diffuse));
  EXPECT_EQ(polished.shininess, 1000.0f);
  EXPECT_TRUE(is_black(rough.reflection));
  expect_near(rough.diffuse, {1, 0.8f, 0.4f});
  EXPECT_LT(rough.shininess, 2.0f);
  const Material satin = material_of(metal + std::string("0.25}}"));
  expect_near(satin.reflection, {0.5f, 0.4f, 0.2f});
  expect_near(satin.diffuse, {0.5f, 0.4f, 0.2f});
}

TEST(GltfMaterial, SmoothPlasticMirrorsALittle) {
  const Material m = material_of(R"({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0}})");
  expect_near(m.reflection, {0.04f, 0.04f, 0.04f});
  expect_near(m.specular, {0.3f, 0.3f, 0.3f});
  expect_near(m.diffuse, {1, 1, 1});
}

TEST(GltfMaterial, GlassRefracts) {
  const Material m = material_of(R"({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
    "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.75}, "KHR_materials_ior": {"ior": 2}}})");
  const float facing = 1.0f / 9.0f;
  expect_near(m.transmission, Vec3{0.75f, 0.75f, 0.75f} * (1.0f - facing));
  expect_near(m.reflection, {facing, facing, facing});
  expect_near(m.diffuse, {0.25f, 0.25f, 0.25f});
  EXPECT_EQ(m.ior, 2.0f);
}

TEST(GltfMaterial, BlendingLetsLightThroughUnbent) {
  const Material m = material_of(R"({"alphaMode": "BLEND", "pbrMetallicRoughness":
    {"baseColorFactor": [1, 1, 1, 0.25], "metallicFactor": 0, "roughnessFactor": 1}})");
  expect_near(m.transmission, {0.75f, 0.75f, 0.75f});
  expect_near(m.diffuse, {0.25f, 0.25f, 0.25f});
  EXPECT_EQ(m.ior, 1.0f);
}

TEST(GltfMaterial, EmissionAndUnlit) {
  const Material lamp = material_of(R"({"emissiveFactor": [1, 0.5, 0],
    "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}})");
  expect_near(lamp.emission, {4, 2, 0});
  const Material unlit = material_of(
      R"({"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1]}, "extensions": {"KHR_materials_unlit": {}}})");
  expect_near(unlit.emission, {0.1f, 0.2f, 0.3f});
  EXPECT_TRUE(is_black(unlit.diffuse) && is_black(unlit.ambient) && is_black(unlit.reflection));
}

TEST(GltfMaterial, ImagesInTheBufferInTheTextAndBesideIt) {
  GltfFile file = with_material(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 1, "texCoord": 1}}})");
  const int view = file.add_view("\x01\x02\x03");
  file.set("images", R"([{"uri": "data:image/png;base64,BAUG"}, {"mimeType": "image/png", "bufferView": )" +
                         std::to_string(view) + R"(}, {"uri": "my%20image.png"}])");
  file.set("textures", R"([{"source": 0}, {"source": 1}, {"source": 2}])");
  const Scene buffer = load(file);
  ASSERT_EQ(buffer.textures.size(), 1u);  // the unused one is not decoded
  EXPECT_EQ(buffer.textures[0].texels, std::vector<u32>{0x030201});
  EXPECT_EQ(buffer.materials.at(0).texture, 0u);
  EXPECT_FLOAT_EQ(buffer.texcoords.at(1).s, 0.25f);

  file.set("materials", R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
  EXPECT_EQ(load(file).textures.at(0).texels, std::vector<u32>{0x060504});

  file.set("materials", R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 2}}}])");
  const Folder folder;
  folder.write("my image.png", "abc");
  EXPECT_EQ(load_mesh(file.write_gltf(folder), {.decode = first_bytes}).textures.at(0).texels,
            std::vector<u32>{0x636261});
}

TEST(GltfMaterial, MissingAndOutlyingImagesBecomeACheckerAndAWarning) {
  for (const char* uri : {"none.png", "../none.png", "data:image/png;base64,AAA="}) {
    GltfFile file = with_material(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})");
    file.set("images", R"([{"uri": ")" + std::string(uri) + R"("}])");
    file.set("textures", R"([{"source": 0}])");
    const Scene scene = load(file);
    EXPECT_EQ(scene.textures.at(0).name, "(missing)") << uri;
    ASSERT_EQ(scene.warnings.size(), 1u) << uri;
    EXPECT_NE(scene.warnings[0].find("scene.gltf: materials/0: "), std::string::npos) << scene.warnings[0];
  }
}

TEST(GltfMaterial, ImagesThatLieOutsideTheBuffer) {
  for (const char* view : {R"({"buffer": 0, "byteOffset": 90, "byteLength": 99})", R"({"buffer": 3, "byteLength": 1})",
                           R"({"buffer": 0, "byteOffset": 18446744073709551615, "byteLength": 9})",
                           R"({"buffer": 0, "byteOffset": -1, "byteLength": 9})"}) {
    const Folder folder;
    const std::filesystem::path path =
        folder.write("scene.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "data:,", "byteLength": 100}],
          "bufferViews": [)" + std::string(view) +
                                       R"(], "images": [{"bufferView": 0, "mimeType": "image/png"}]})");
    EXPECT_NE(message_of([&] { load_mesh(path); }), "") << view;
  }
}

TEST(GltfMaterial, ImagesThatShareBytes) {
  GltfFile file = with_material(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
    "metallicRoughnessTexture": {"index": 1}}}, {"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}})");
  const std::string view = std::to_string(file.add_view(std::string(1000, '\x03')));
  const std::string image = R"({"mimeType": "image/png", "bufferView": )" + view + "}";
  file.set("images", "[" + image + ", " + image + "]");
  file.set("textures", R"([{"source": 0}, {"source": 1}])");
  int decoded = 0;
  const auto decode = [&](std::span<const u8> bytes) {
    ++decoded;
    return first_bytes(bytes);
  };
  const Folder folder;
  const Scene scene = load_mesh(file.write_glb(folder), {.decode = decode});
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(decoded, 2);  // once for the texture, once for the mean

  // Views that overlap could ask for decodings without end.
  const std::string overlapping = R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "data:,", "byteLength": 100}],
    "bufferViews": [{"buffer": 0, "byteLength": 60}, {"buffer": 0, "byteLength": 59}],
    "images": [{"bufferView": 0, "mimeType": "image/png"}, {"bufferView": 1, "mimeType": "image/png"}]})";
  const std::string message = message_of([&] { load_mesh(folder.write("scene.gltf", overlapping)); });
  EXPECT_NE(message.find("images overlap each other"), std::string::npos) << message;
}

TEST(GltfMaterial, MeansOfTexturesThatAreNotModelled) {
  GltfFile file = with_material(R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0},
    "pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 1}}})");
  file.set("images", R"([{"uri": "data:image/png;base64,/wAA"}, {"uri": "data:image/png;base64,AAD/"}])");
  file.set("textures", R"([{"source": 0}, {"source": 1}])");
  const Scene scene = load(file);
  expect_near(scene.materials.at(0).emission, {1, 0, 0});
  expect_near(scene.materials[0].reflection, {1, 1, 1});  // no roughness, all metal
  EXPECT_TRUE(scene.textures.empty());
}

TEST(GltfMaterial, TexcoordsAreTransformed) {
  GltfFile file = with_material(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
    {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 1.5707963267948966, "scale": [2, 4]}}}}})");
  file.set("images", R"([{"uri": "data:image/png;base64,AAAA"}])");
  file.set("textures", R"([{"source": 0}])");
  const Scene scene = load(file);
  const auto near = [](TexCoord a, float s, float t) {
    EXPECT_NEAR(a.s, s, 1e-6f);
    EXPECT_NEAR(a.t, t, 1e-6f);
  };
  near(scene.texcoords.at(0), 0.5f, 0.25f);
  near(scene.texcoords.at(1), 0.5f, -1.75f);  // t runs down, so that a quarter turn takes s upwards
  near(scene.texcoords.at(2), 4.5f, 0.25f);
}

TEST(GltfMaterial, WrongIndices) {
  const auto message = [](const std::string& material) {
    const Folder folder;
    const std::filesystem::path path = with_material(material).write_gltf(folder);
    return message_of([&] { load_mesh(path, {.decode = first_bytes}); });
  };
  EXPECT_NE(message(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 5}}})")
                .find("scene.gltf: materials/0: texture 5 of 0"),
            std::string::npos);
  EXPECT_NE(message(R"({"emissiveFactor": [-1, 0, 0]})").find("materials/0: the emission is negative"),
            std::string::npos);
}

struct Original {
  const char* path;
  u64 triangles;
  size_t textures;
};

TEST(GltfOriginals, Counts) {
  const char* data = std::getenv("RAYWALK_SCENE_DATA");
  if (data == nullptr) GTEST_SKIP() << "RAYWALK_SCENE_DATA names no folder of original scene data";
  u32 found = 0;
  for (const Original& original : {Original{"sponza/sponza.glb", 262205, 19},
                                   {"gltf_damagedhelmet/DamagedHelmet.gltf", 15452, 1},
                                   {"gltf_misc/balloon/scene.gltf", 35698, 17}}) {
    const std::filesystem::path path = std::filesystem::path(data) / original.path;
    if (!std::filesystem::exists(path)) continue;
    ++found;
    const Scene scene = load_mesh(path, {.decode = first_bytes});
    EXPECT_EQ(scene.triangles.size(), original.triangles) << path;
    EXPECT_EQ(scene.textures.size(), original.textures) << path;
    for (const std::string& warning : scene.warnings) ADD_FAILURE() << warning;
  }
  for (const char* name : {"gltf_misc/Box.glb", "gltf_misc/BoxTextured.glb"}) {
    const std::filesystem::path path = std::filesystem::path(data) / name;
    if (!std::filesystem::exists(path)) continue;
    ++found;
    EXPECT_EQ(message_of([&] { load_mesh(path); }),
              path.string() + ": the file requires the extension 'KHR_draco_mesh_compression', which is not supported");
  }
  if (found == 0) GTEST_SKIP() << "no glTF files in " << data;
}

}  // namespace
}  // namespace raywalk
