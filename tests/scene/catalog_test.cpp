// Manifests, listing and loading; the real bunny where it is present.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "kernels/features.h"
#include "server/scene/catalog_files.h"
#include "server/scene/manifest.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

const std::filesystem::path kNoData = "there-is-no-such-folder";

std::string manifest(const std::string& source,
                     const std::string& lights = R"([{"position":[0,5,0],"intensity":[1,1,1]}])",
                     const std::string& more = "") {
  return R"({"title":"T","prose":"P","source":)" + source +
         R"(,"materials":[{"name":"m","diffuse":[1,1,1]}],"lights":)" + lights +
         R"(,"ambient":[0,0,0],"background":[0,0,0],"camera":{"frames":10,"orbit":{"radius_factor":2,)" +
         R"("elevation_deg":10,"start_deg":0,"turns":1,"fov_deg":45}})" + more + "}";
}
const std::string kSoup = R"({"generator":{"name":"soup","triangles":50}})";

TEST(Catalogue, lists_what_ships) {
  const std::vector<SceneInfo> scenes = list_scenes(scenes_dir(), kNoData);
  for (const SceneInfo& s : scenes) {
    EXPECT_GE(s.lights, 1u);
    EXPECT_EQ(s.frames, 400u);
    EXPECT_FALSE(s.title.empty() || s.prose.empty() || s.source.empty());
    EXPECT_TRUE(s.available || !s.credit.empty());
  }
  for (const char* studied :
       {"bunny", "dragon", "buddha", "robots", "museum", "kitchen", "theatre", "office", "conference"}) {
    const auto scene =
        std::find_if(scenes.begin(), scenes.end(), [&](const SceneInfo& s) { return s.name == studied; });
    ASSERT_NE(scene, scenes.end()) << studied;
    EXPECT_EQ(scene->fidelity, Fidelity::kStandIn) << studied;
    EXPECT_FALSE(scene->fidelity_note.empty()) << studied;
    EXPECT_TRUE(scene->available) << studied;
    const auto table1 = nlohmann::json::parse(scene->paper_json).at("table1");
    EXPECT_EQ(table1.at("triangles"), scene->triangles) << studied;
    EXPECT_EQ(table1.at("lights"), scene->lights) << studied;
  }
}

TEST(Catalogue, loads_what_it_lists) {
  for (const SceneInfo& info : list_scenes(scenes_dir(), kNoData)) {
    if (!info.available) {
      EXPECT_NE(message_of([&] { load_scene(info.name, scenes_dir(), kNoData); }).find("its data is not at"),
                std::string::npos);
      continue;
    }
    if (info.name == "dragon" || info.name == "buddha") continue;  // a million triangles of what the others are made of
    const Scene scene = load_scene(info.name, scenes_dir(), kNoData);
    EXPECT_EQ(scene.triangles.size(), info.triangles);
    EXPECT_EQ(scene.lights.size(), info.lights);
    EXPECT_EQ(scene.fidelity, info.fidelity);
    EXPECT_EQ(scene.content_sha256, geometry_sha256(scene));
    EXPECT_TRUE(scene.warnings.empty());
    const Blob blob = pack(scene);
    EXPECT_EQ(blob.header<SceneHeader>().corners.count, info.triangles);
  }
}

TEST(Catalogue, room_has_every_feature_but_textures) {
  EXPECT_EQ(features_of(load_scene("room", scenes_dir(), kNoData, 30'000)), kAllFeatures & ~kFeatureTextures);
}

TEST(Catalogue, triangle_count_can_be_chosen) {
  EXPECT_EQ(load_scene("soup", scenes_dir(), kNoData, 7).triangles.size(), 7u);
  EXPECT_EQ(load_scene("bunny", scenes_dir(), kNoData, 5000).fidelity, Fidelity::kStandIn);
  EXPECT_THROW(load_scene("room", scenes_dir(), kNoData, 7), std::invalid_argument);
}

TEST(Catalogue, unknown_scene_names_the_known) {
  try {
    load_scene("teapot", scenes_dir(), kNoData);
    FAIL();
  } catch (const UnknownScene& e) {
    EXPECT_NE(std::string(e.what()).find("bunny"), std::string::npos);
  }
  EXPECT_THROW(load_scene("../scenes/bunny", scenes_dir(), kNoData), UnknownScene);
}

TEST(Catalogue, original_data_is_preferred_and_checked) {
  const Folder folder;
  folder.write("scenes/one/scene.json",
               manifest(R"({"original":{"file":"one/mesh.ply","sha256":")" + std::string(64, '0') +
                        R"(","triangles":1,"fidelity":"original","credit":"me","home":"http://example.org/one"},)" +
                        R"("generator":{"name":"soup","triangles":50}})"));
  const auto scenes = folder.path() / "scenes", data = folder.path() / "data";
  EXPECT_EQ(load_scene("one", scenes, data).fidelity, Fidelity::kStandIn);
  folder.write(
      "data/one/mesh.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(list_scenes(scenes, data)[0].fidelity, Fidelity::kOriginal);
  const Scene scene = load_scene("one", scenes, data);
  EXPECT_EQ(scene.triangles.size(), 1u);
  EXPECT_EQ(scene.fidelity, Fidelity::kDerived);  // another hash than the manifest's
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("mesh.ply"), std::string::npos);
}

TEST(Catalogue, an_original_may_bring_its_look_or_have_one_of_its_own) {
  const Folder folder;
  const auto one = [&](const std::string& more) {
    folder.write("scenes/one/scene.json",
                 manifest(R"({"original":{"file":"one/mesh.obj","sha256":")" + std::string(64, '0') +
                          R"(","triangles":1,"fidelity":"derived","change":"less of it","credit":"me")" + more + "}}"));
    return load_scene("one", folder.path() / "scenes", folder.path() / "data");
  };
  folder.write("data/one/mesh.obj", "mtllib mesh.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("data/one/mesh.mtl", "newmtl red\nKd 1 0 0\n");
  EXPECT_EQ(one("").materials[0].diffuse, (Vec3{1, 1, 1}));
  const Scene own =
      one(R"(,"split_to":4,"look":{"materials":"file","lights":[{"position":[1,2,3],"intensity":[1,1,1]},)"
          R"({"position":[3,2,1],"intensity":[1,1,1]}],"background":[0,0,1],)"
          R"("camera":{"frames":7,"up":[0,0,1],"spline":[{"eye":[0,0,3],"target":[0,0,0],"fov_deg":40},)"
          R"({"eye":[0,1,3],"target":[0,0,0],"fov_deg":40}]}})");
  EXPECT_EQ(own.materials[0].diffuse, (Vec3{1, 0, 0}));
  EXPECT_EQ(own.lights.size(), 2u);
  EXPECT_EQ(own.background, (Vec3{0, 0, 1}));
  EXPECT_EQ(own.camera_path.frames, 7u);
  EXPECT_EQ(pose_at(own.camera_path, 0, 7).up, (Vec3{0, 0, 1}));
  EXPECT_EQ(own.triangles.size(), 4u);
  for (const char* bad : {R"(,"look":{"camera":"file"})", R"(,"look":{"file_lights":[1]})", R"(,"look":{"lights":[]})",
                          R"(,"look":{"materials":3})", R"(,"split_to":0)", R"(,"sphere":[1,1])"}) {
    EXPECT_THROW(one(bad), std::runtime_error) << bad;
  }
}

TEST(Catalogue, the_real_bunny) {
  const char* data = std::getenv("RAYWALK_SCENE_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path(data) / "bunny/bun_zipper.ply")) {
    GTEST_SKIP() << "RAYWALK_SCENE_DATA has no bunny/bun_zipper.ply";
  }
  const Scene scene = load_scene("bunny", scenes_dir(), data);
  EXPECT_EQ(scene.fidelity, Fidelity::kOriginal);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.triangles.size(), 69451u);
  EXPECT_EQ(scene.positions.size(), 35947u);
  const Box box = bounds_of(scene);
  EXPECT_FLOAT_EQ(box.lo.x, -0.0946899f);
  EXPECT_FLOAT_EQ(box.hi.y, 0.187321f);
}

struct BadManifest {
  const char* name;
  std::string content;
  std::vector<std::string> says;
};
void PrintTo(const BadManifest& bad, std::ostream* out) {
  *out << bad.name;
}

class Manifests : public testing::TestWithParam<BadManifest> {};

TEST_P(Manifests, bad_ones_are_refused) {
  const Folder folder;
  const auto file = folder.write("bad/scene.json", GetParam().content);
  const std::string message = message_of([&] { list_scenes(folder.path(), kNoData); });
  EXPECT_NE(message.find(file.string()), std::string::npos) << message;
  for (const std::string& part : GetParam().says) EXPECT_NE(message.find(part), std::string::npos) << message;
}

const std::string kOriginal =
    R"({"original":{"file":"FILE","sha256":"SHA","triangles":1,"fidelity":"original","credit":"c","home":"h"}})";
std::string original(const std::string& file, const std::string& sha) {
  std::string text = kOriginal;
  text.replace(text.find("FILE"), 4, file);
  return text.replace(text.find("SHA"), 3, sha);
}

INSTANTIATE_TEST_SUITE_P(
    , Manifests,
    testing::Values(
        BadManifest{"no_json", "{\"title\": ", {"not JSON"}}, BadManifest{"no_object", "[1]", {": /: ", "object"}},
        BadManifest{"no_source", manifest("{}"), {"/source", "generator"}},
        BadManifest{"no_lights", manifest(kSoup, "[]"), {"/lights", "at least 1"}},
        BadManifest{"light_text",
                    manifest(kSoup, R"([{"position":[0,"x",0],"intensity":[1,1,1]}])"),
                    {"/lights/0/position/1", "number"}},
        BadManifest{"unknown_key",
                    manifest(kSoup, R"([{"position":[0,0,0],"intensity":[1,1,1],"colour":1}])"),
                    {"/lights/0/colour", "unknown key"}},
        BadManifest{
            "climbing_path", manifest(original("../x.ply", std::string(64, 'a'))), {"/source/original/file", "inside"}},
        BadManifest{"hash", manifest(original("x.ply", "abc")), {"/source/original/sha256", "64"}},
        BadManifest{
            "count", manifest(R"({"generator":{"name":"soup","triangles":0}})"), {"/source/generator/triangles"}},
        BadManifest{"paper",
                    manifest(kSoup, R"([{"position":[0,5,0],"intensity":[1,1,1]}])", R"(,"paper":{"source":"s"})"),
                    {"/paper", "table1"}}),
    [](const auto& each) { return each.param.name; });

TEST(Manifest, two_cameras_are_refused) {
  const Folder folder;
  std::string text = manifest(kSoup);
  text.replace(text.find("\"orbit\""), 7, "\"spline\":[],\"orbit\"");
  folder.write("bad/scene.json", text);
  EXPECT_NE(message_of([&] { read_manifest(folder.path() / "bad/scene.json"); }).find("/camera: must have one of"),
            std::string::npos);
}

}  // namespace
}  // namespace raywalk::test
