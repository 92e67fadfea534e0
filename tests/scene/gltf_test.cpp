// glTF: containers, accessors, nodes, materials, lights, cameras, and what is refused.
#include <gtest/gtest.h>

#include <cstdlib>

#include "server/scene/importer.h"
#include "tests/scene/files.h"
#include "tests/scene/gltf_file.h"

namespace raywalk {
namespace {

using test::Folder;
using test::GltfFile;
using test::message_of;

Scene load(const GltfFile& file) {
  const Folder folder;
  return load_mesh(file.write_gltf(folder));
}

/// What is said about the file, without its folder.
std::string refusal(const GltfFile& file) {
  const Folder folder;
  const std::filesystem::path path = file.write_gltf(folder);
  const std::string message = message_of([&] { load_mesh(path); });
  return message.starts_with(path.string()) ? "scene.gltf" + message.substr(path.string().size()) : message;
}

/// Whether a warning holds the text.
bool warns(const Scene& scene, const std::string& text) {
  for (const std::string& warning : scene.warnings) {
    if (warning.find(text) != warning.npos) return true;
  }
  return false;
}

void expect_near(Vec3 a, Vec3 b) {
  EXPECT_NEAR(a.x, b.x, 1e-6f);
  EXPECT_NEAR(a.y, b.y, 1e-6f);
  EXPECT_NEAR(a.z, b.z, 1e-6f);
}

/// The triangle (0,0,0) (1,0,0) (0,1,0) as accessor 0, and one node with the mesh.
GltfFile triangle() {
  GltfFile file;
  file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])");
  file.set("nodes", R"([{"mesh": 0}])");
  return file;
}

TEST(Gltf, TextAndBinaryAreTheSame) {
  const Folder folder;
  const GltfFile file = triangle();
  const Scene text = load_mesh(file.write_gltf(folder)), binary = load_mesh(file.write_glb(folder));
  EXPECT_EQ(text.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(text.triangles.size(), 1u);
  EXPECT_EQ(text.content_sha256, binary.content_sha256);
  EXPECT_TRUE(text.normals.empty());
  EXPECT_TRUE(text.texcoords.empty());
  EXPECT_TRUE(text.warnings.empty());
  expect_near(text.materials.at(0).diffuse, default_material().diffuse);
}

TEST(Gltf, ContentGoesBeforeTheExtension) {
  const Folder folder;
  for (const auto& path : {triangle().write_gltf(folder), triangle().write_glb(folder)}) {
    const std::filesystem::path renamed = folder.path() / "scene.ply";
    std::filesystem::rename(path, renamed);
    EXPECT_EQ(load_mesh(renamed).triangles.size(), 1u);
  }
}

TEST(Gltf, BuffersBesideTheFile) {
  const Folder folder;
  EXPECT_EQ(load_mesh(triangle().write_gltf(folder, "a buffer.bin", "a%20buffer.bin")).triangles.size(), 1u);
  const std::string missing = message_of([&] { load_mesh(triangle().write_gltf(folder, "here.bin", "there.bin")); });
  EXPECT_NE(missing.find("there.bin"), missing.npos) << missing;
  for (const char* outside : {"../secret.bin", "a/../../secret.bin", "..%2fsecret.bin", "/etc/passwd"}) {
    const std::string message = message_of([&] { load_mesh(triangle().write_gltf(folder, "here.bin", outside)); });
    EXPECT_NE(message.find("lies outside the scene's folder"), message.npos) << message;
  }
}

TEST(Gltf, NodesMoveTurnScaleAndMirror) {
  GltfFile file = triangle();
  file.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}])");
  file.set("scenes", R"([{"nodes": []}, {"nodes": [0, 3]}])");
  file.set("scene", "1");
  file.set("nodes", R"([
    {"children": [1, 2], "translation": [10, 0, 0]},
    {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 3, 1]},
    {"mesh": 0, "scale": [-1, 1, 1]},
    {"mesh": 0, "matrix": [1,0,0,0, 0,0,-1,0, 0,1,0,0, 0,0,5,1]}])");
  const Scene scene = load(file);
  ASSERT_EQ(scene.positions.size(), 9u);
  expect_near(scene.positions[1], {10, 2, 0});  // scaled, turned by 90 degrees about z, moved
  expect_near(scene.positions[2], {7, 0, 0});
  expect_near(scene.positions[4], {9, 0, 0});
  expect_near(scene.positions[8], {0, 0, 4});
  expect_near(scene.normals[0], {0, 0, 1});
  expect_near(scene.normals[3], {0, 0, 1});
  expect_near(scene.normals[6], {0, 1, 0});
  // Mirrored: the winding turns over, so that it still agrees with the normal.
  EXPECT_EQ(scene.triangles[1].b, 5u);
  EXPECT_EQ(scene.triangles[1].c, 4u);
}

TEST(Gltf, NormalsOfUnevenScalesStayPerpendicular) {
  GltfFile file = triangle();
  const float h = 0.70710678f;
  file.add_floats({h, h, 0, h, h, 0, h, h, 0}, "VEC3");
  file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}])");
  file.set("nodes", R"([{"mesh": 0, "scale": [2, 1, 1]}])");
  const float length = std::sqrt(0.25f + 1.0f);
  expect_near(load(file).normals.at(0), {0.5f / length, 1.0f / length, 0});
}

TEST(Gltf, StripsAndFans) {
  const auto triangles_of = [](int mode, std::vector<u32> indices) {
    GltfFile file;
    file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
    file.add(test::bytes_of(indices), 5125, indices.size(), "SCALAR");
    file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": )" +
                           std::to_string(mode) + "}]}]");
    file.set("nodes", R"([{"mesh": 0}])");
    std::vector<u32> flat;
    for (const TriangleIndices& t : load(file).triangles) flat.insert(flat.end(), {t.a, t.b, t.c});
    return flat;
  };
  EXPECT_EQ(triangles_of(4, {0, 1, 2, 2, 1, 3, 0}), (std::vector<u32>{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(triangles_of(5, {0, 1, 2, 3}), (std::vector<u32>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(triangles_of(5, {0, 1, 2, 2, 3, 1}), (std::vector<u32>{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(triangles_of(6, {0, 1, 3, 2}), (std::vector<u32>{0, 1, 3, 0, 3, 2}));
  EXPECT_TRUE(triangles_of(1, {0, 1, 2}).empty());
}

TEST(Gltf, IndicesOfEveryWidth) {
  const auto count_of = [](auto zero, int type) {
    using Index = decltype(zero);
    GltfFile file = triangle();
    file.add(test::bytes_of(std::vector<Index>{2, 0, 1}), type, 3, "SCALAR");
    file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])");
    const Scene scene = load(file);
    return scene.triangles.size() == 1 && scene.triangles[0].a == 2 && scene.triangles[0].b == 0;
  };
  EXPECT_TRUE(count_of(u8{0}, 5121));
  EXPECT_TRUE(count_of(std::uint16_t{0}, 5123));
  EXPECT_TRUE(count_of(u32{0}, 5125));
}

TEST(Gltf, NormalisedTexcoordsAndQuantisedPositions) {
  GltfFile file;
  file.set("extensionsRequired", R"(["KHR_mesh_quantization"])");
  // Three shorts a position, with a stride of eight bytes.
  file.add(test::bytes_of(std::vector<std::int16_t>{0, 0, 0, 0, -7, 0, 0, 0, 0, 9, 1, 0}), 5122, 3, "VEC3",
           R"(, "normalized": false)", 8);
  file.add(test::bytes_of(std::vector<u8>{0, 255, 51, 0, 255, 102}), 5121, 3, "VEC2", R"(, "normalized": true)");
  file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}])");
  file.set("nodes", R"([{"mesh": 0}])");
  const Scene scene = load(file);
  EXPECT_EQ(scene.positions, (std::vector<Vec3>{{0, 0, 0}, {-7, 0, 0}, {0, 9, 1}}));
  ASSERT_EQ(scene.texcoords.size(), 3u);
  EXPECT_FLOAT_EQ(scene.texcoords[0].t, 1.0f);
  EXPECT_FLOAT_EQ(scene.texcoords[1].s, 0.2f);
  EXPECT_FLOAT_EQ(scene.texcoords[2].t, 0.4f);
}

TEST(Gltf, SparseValues) {
  GltfFile file = triangle();
  const int indices = file.add_view(test::bytes_of(std::vector<u8>{1}));
  const int values = file.add_view(test::bytes_of(std::vector<float>{5, 6, 7}));
  const std::string sparse = R"(, "sparse": {"count": 1, "indices": {"bufferView": )" + std::to_string(indices) +
                             R"(, "componentType": 5121}, "values": {"bufferView": )" + std::to_string(values) + "}}";
  file.add_accessor(R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3")" + sparse + "}");
  file.add_accessor(R"({"componentType": 5126, "count": 3, "type": "VEC3")" + sparse + "}");
  file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 1}}, {"attributes": {"POSITION": 2}}]}])");
  const Scene scene = load(file);
  EXPECT_EQ(scene.positions, (std::vector<Vec3>{{0, 0, 0}, {5, 6, 7}, {0, 1, 0}, {0, 0, 0}, {5, 6, 7}, {0, 0, 0}}));
}

TEST(Gltf, WhatLiesOutsideIsRefused) {
  const auto refused = [](const std::string& accessor) {
    GltfFile file = triangle();
    file.add_accessor(accessor);
    file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 1}}]}])");
    return refusal(file);
  };
  const std::string outside = "scene.gltf: meshes/0/primitives/0: accessor 1 lies outside bufferView 0";
  EXPECT_EQ(refused(R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"})"), outside);
  EXPECT_EQ(refused(R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "byteOffset": 4})"),
            outside);
  EXPECT_EQ(refused(R"({"bufferView": 0, "componentType": 5126, "count": 100000000, "type": "VEC3"})"), outside);
  EXPECT_EQ(refused(R"({"bufferView": 9, "componentType": 5126, "count": 3, "type": "VEC3"})"),
            "scene.gltf: meshes/0/primitives/0: accessor 1 has no bufferView 9");
  EXPECT_EQ(refused(R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"})"),
            "scene.gltf: meshes/0/primitives/0: accessor 1 has 2 components, not 3");
  EXPECT_EQ(refused(R"({"componentType": 5126, "count": 100000000, "type": "VEC3"})"),
            "scene.gltf: meshes/0/primitives/0: accessor 1 has 100000000 values, and no bufferView");
}

TEST(Gltf, IndicesThatNameNoVertex) {
  GltfFile file = triangle();
  file.add(test::bytes_of(std::vector<u8>{0, 1, 3}), 5121, 3, "SCALAR");
  file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])");
  EXPECT_EQ(refusal(file), "scene.gltf: meshes/0/primitives/0: accessor 1 names vertex 3 of 3");
}

TEST(Gltf, NumbersThatAreNotFinite) {
  GltfFile file = triangle();
  file.add_floats({0, 0, 0, NAN, 0, 0, 0, 0, 0}, "VEC3");
  file.set("meshes", R"([{"primitives": [{"attributes": {"POSITION": 1}}]}])");
  EXPECT_EQ(refusal(file), "scene.gltf: meshes/0/primitives/0: accessor 1 is not finite in value 1");
  GltfFile far = triangle();
  far.set("nodes", R"([{"mesh": 0, "scale": [1e300, 1, 1]}])");
  EXPECT_EQ(refusal(far), "scene.gltf: meshes/0/primitives/0: vertex 1 is moved beyond all numbers by its node");
  GltfFile bright = triangle();
  bright.set("extensions", R"({"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 1e300}]}})");
  bright.set("nodes", R"([{"extensions": {"KHR_lights_punctual": {"light": 0}}}])");
  EXPECT_EQ(refusal(bright), "scene.gltf: nodes/0: the light's intensity or position is not finite, or negative");
}

TEST(Gltf, NodesThatAreNoTree) {
  GltfFile file = triangle();
  file.set("scenes", R"([{"nodes": [0]}])");
  file.set("nodes", R"([{"mesh": 0, "children": [1]}, {"children": [0]}])");
  EXPECT_EQ(refusal(file), "scene.gltf: nodes/0: has two parents, or is its own ancestor");
  file.set("nodes", R"([{"mesh": 0, "children": [7]}])");
  EXPECT_EQ(refusal(file), "scene.gltf: nodes/7: node 7 of 1");
  file.set("nodes", R"([{"mesh": 4}])");
  EXPECT_EQ(refusal(file), "scene.gltf: nodes/0: mesh 4 of 1");
}

TEST(Gltf, AChainOfManyNodesIsNoRecursion) {
  GltfFile file = triangle();
  constexpr int kNodes = 100'000;
  std::string nodes = "[";
  for (int i = 0; i + 1 < kNodes; ++i) nodes += R"({"children":[)" + std::to_string(i + 1) + "]},";
  file.set("nodes", nodes + R"({"mesh": 0}])");
  EXPECT_EQ(load(file).triangles.size(), 1u);
}

TEST(Gltf, InstancesCountAgainstTheLimit) {
  const Folder folder;
  GltfFile file = triangle();
  file.set("nodes", R"([{"mesh": 0}, {"mesh": 0}, {"mesh": 0}])");
  const std::filesystem::path path = file.write_gltf(folder);
  ImportSettings settings;
  settings.limits.triangles = 2;
  const std::string message = message_of([&] { load_mesh(path, settings); });
  EXPECT_EQ(message, path.string() + ": meshes/0/primitives/0: more than 2 triangles");
}

TEST(Gltf, BadJson) {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    return message_of([&] { load_mesh(folder.write("bad.gltf", text)); });
  };
  const std::string path = (folder.path() / "bad.gltf").string();
  EXPECT_TRUE(refused("{\n\"asset\": {\n]}").starts_with(path + ", line 3: not JSON")) << refused("{\n]");
  EXPECT_EQ(refused("[]"), path + ": not a glTF file: the JSON is no object");
  EXPECT_EQ(refused("{}"), path + ": not a glTF file: there is no asset version");
  EXPECT_EQ(refused(R"({"asset": {"version": "1.0"}})"), path + ": glTF version '1.0'; only 2.x is known");
  EXPECT_EQ(refused(R"({"asset": {"version": "2.0"}, "extras": )" + std::string(100'000, '[')),
            path + ", line 1: JSON nested deeper than 64 levels");
  const std::string endless = refused("{\"asset\": {\"version\": \"2.0\"},\n\"scene\": 1e999}");
  EXPECT_TRUE(endless.starts_with(path + ", line 2: ") && endless.ends_with("'1e999'")) << endless;
  EXPECT_FALSE(refused(R"({"asset": {"version": "2.0"}, "nodes": [7]})").empty());
  EXPECT_FALSE(refused("").empty());
}

TEST(Gltf, BadContainers) {
  const Folder folder;
  const std::filesystem::path path = triangle().write_glb(folder);
  const std::string good = test::text_of(path);
  for (size_t length = 4; length < good.size(); ++length) {
    EXPECT_FALSE(message_of([&] { load_mesh(folder.write("cut.glb", good.substr(0, length))); }).empty()) << length;
  }
  std::string version = good;
  version[4] = 1;
  EXPECT_NE(message_of([&] { load_mesh(folder.write("old.glb", version)); }).find("version 1"), std::string::npos);
}

TEST(Gltf, RequiredExtensionsAreRefusedByName) {
  GltfFile file = triangle();
  file.set("extensionsRequired", R"(["KHR_materials_ior", "KHR_draco_mesh_compression"])");
  EXPECT_EQ(refusal(file),
            "scene.gltf: the file requires the extension 'KHR_draco_mesh_compression', which is not supported");
}

TEST(Gltf, LightsGetTheStrengthThatTheyHaveInTheScene) {
  GltfFile file = triangle();
  file.set("extensions", R"({"KHR_lights_punctual": {"lights": [
    {"type": "point", "intensity": 400, "color": [1, 0.5, 0]}, {"type": "directional", "intensity": 4}]}})");
  file.set("nodes", R"([{"mesh": 0},
    {"translation": [0.5, 0.5, 10], "extensions": {"KHR_lights_punctual": {"light": 0}}},
    {"extensions": {"KHR_lights_punctual": {"light": 1}}}])");
  const Scene scene = load(file);
  ASSERT_EQ(scene.lights.size(), 2u);
  expect_near(scene.lights[0].position, {0.5f, 0.5f, 10});
  const float half = 0.70710678f;  // 400 cd from 10 m are 4 lx
  expect_near(scene.lights[0].intensity, {half, 0.5f * half, 0});
  expect_near(scene.lights[1].intensity, {half, half, half});
  EXPECT_NEAR(scene.lights[1].position.x, 0.5f, 1e-4f);
  EXPECT_GT(scene.lights[1].position.z, 100.0f);  // its rays go down the z axis
  expect_near(scene.ambient, {0.12f, 0.12f, 0.12f});
}

TEST(Gltf, Cameras) {
  GltfFile file = triangle();
  file.set("cameras", R"([{"type": "perspective", "name": "front", "perspective": {"yfov": 1.0471975511965976,
    "znear": 0.1}}, {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "zfar": 9, "znear": 0}}])");
  file.set("nodes", R"([{"mesh": 0},
    {"camera": 0, "translation": [1, 2, 3], "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]},
    {"camera": 1}])");
  const Scene scene = load(file);
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].name, "front");
  expect_near(scene.cameras[0].pose.eye, {1, 2, 3});
  expect_near(scene.cameras[0].pose.target, {0, 2, 3});
  expect_near(scene.cameras[0].pose.up, {0, 1, 0});
  EXPECT_NEAR(scene.cameras[0].pose.vertical_fov_deg, 60.0f, 1e-4f);
  EXPECT_TRUE(warns(scene, "nodes/2: only perspective cameras"));
}

}  // namespace
}  // namespace raywalk
