// Manifests, listing and loading; the real bunny where it is present.
#include <gtest/gtest.h>

#include <cstdlib>

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
  std::vector<std::string> names;
  for (const SceneInfo& s : scenes) {
    names.push_back(s.name);
    EXPECT_GE(s.lights, 1u);
    EXPECT_EQ(s.frames, 400u);
    EXPECT_FALSE(s.title.empty() || s.prose.empty() || s.source.empty());
    EXPECT_EQ(s.home_url.empty(), s.credit.empty());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"bunny", "city", "dragon", "organic", "room", "soup"}));
  EXPECT_EQ(scenes[0].triangles, 69451u);
  EXPECT_EQ(scenes[0].fidelity, Fidelity::kStandIn);
  EXPECT_NE(scenes[0].paper_json.find("\"references_per_triangle\":3.7"), std::string::npos);
  EXPECT_EQ(scenes[2].triangles, 871414u);
  EXPECT_EQ(scenes[3].fidelity, Fidelity::kProcedural);
}

TEST(Catalogue, loads_what_it_lists) {
  for (const SceneInfo& info : list_scenes(scenes_dir(), kNoData)) {
    if (info.name == "dragon") continue;  // the same generator at 12 times the bunny's size
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

TEST(Catalogue, room_has_every_feature) {
  EXPECT_EQ(features_of(load_scene("room", scenes_dir(), kNoData, 30'000)), kAllFeatures);
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
    EXPECT_EQ(e.known().size(), 6u);
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
