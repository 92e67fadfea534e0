// OBJ and MTL: what must be read, what must be told, and what must be refused.
#include <gtest/gtest.h>

#include <chrono>
#include <clocale>
#include <cstdlib>

#include "server/scene/importer.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

std::filesystem::path sample(const char* name) {
  return scenes_dir().parent_path() / "tests/scene/data/obj" / name;
}

/// Stands for a decoder of images.
Texture two_by_two(std::span<const u8>) {
  return {"", 2, 2, {1, 2, 3, 4}};
}

bool warned(const Scene& scene, const std::string& part) {
  for (const std::string& warning : scene.warnings) {
    if (warning.find(part) != std::string::npos) return true;
  }
  return false;
}

void expect_color(Vec3 color, Vec3 expected) {
  for (u32 i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(color[i], expected[i]) << "component " << i;
}

TEST(Obj, sample) {
  const Scene scene = load_mesh(sample("room.obj"), {.decode = two_by_two});
  EXPECT_EQ(scene.warnings, std::vector<std::string>());
  ASSERT_EQ(scene.triangles.size(), 2u + 3u + 2u + 1u);
  ASSERT_EQ(scene.materials.size(), 4u);
  ASSERT_EQ(scene.positions.size(), 4u + 5u + 4u + 3u);
  const u32 of_triangle[] = {0, 0, 1, 1, 1, 2, 2, 3};
  for (size_t i = 0; i < 8; ++i) EXPECT_EQ(scene.triangles[i].material, of_triangle[i]);

  // The floor: its normals have unit length, its first corner has the image's lower left corner.
  EXPECT_EQ(scene.normals[0], (Vec3{0, 1, 0}));
  EXPECT_EQ(scene.positions[0], (Vec3{-2, 0, 2}));
  EXPECT_EQ(scene.texcoords[0].s, 0.0f);
  EXPECT_EQ(scene.texcoords[0].t, 1.0f);
  EXPECT_EQ(scene.texcoords[2].s, 4.0f);
  EXPECT_EQ(scene.texcoords[2].t, -3.0f);
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.materials[0].texture, 0u);
  // The wall has no normals of its own, and its corners are the floor's by position only.
  EXPECT_EQ(scene.normals[4], (Vec3{0, 0, 0}));
  EXPECT_EQ(scene.positions[4], (Vec3{-2, 0, -2}));
  EXPECT_EQ(scene.positions[8], (Vec3{-2, 3, -2}));
}

TEST(Obj, materials) {
  const Scene scene = load_mesh(sample("room.obj"), {.decode = two_by_two});
  const Material& wall = scene.materials[1];
  expect_color(wall.diffuse, {0.8f, 0.7f, 0.6f});
  expect_color(wall.ambient, {0.8f, 0.7f, 0.6f});
  expect_color(wall.specular, {0.1f, 0.1f, 0.1f});
  expect_color(wall.reflection, {0, 0, 0});
  EXPECT_EQ(wall.shininess, 20.0f);
  EXPECT_EQ(wall.texture, kNoTexture);
  expect_color(scene.materials[2].reflection, {0.9f, 0.9f, 0.9f});
  const Material& glass = scene.materials[3];
  expect_color(glass.diffuse, {0.05f, 0.05f, 0.05f});
  expect_color(glass.transmission, {0.675f, 0.75f, 0.675f});
  expect_color(glass.emission, {0, 0.5f, 0});
  EXPECT_EQ(glass.ior, 1.5f);
}

TEST(Obj, material_rules) {
  const Folder folder;
  folder.write("a.mtl",
               "newmtl alpha\nTr 0.5\nNi 1.5\nillum 2\nnewmtl tinted\nTf 0 1 0\nillum 6\nNi 1.3\n"
               "newmtl opaque\nTf 1 1 1\nillum 4\nd 1\nnewmtl matte\nKs 1 1 1\nillum 1\nnewmtl bright\nKd 2 -1 0.5\n"
               "Ns 0\nnewmtl grey\nKd 0.25\n");
  std::string text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* name : {"alpha", "tinted", "opaque", "matte", "bright", "grey"}) {
    text += "usemtl " + std::string(name) + "\nf 1 2 3\n";
  }
  const Scene scene = load_mesh(folder.write("a.obj", text));
  ASSERT_EQ(scene.materials.size(), 6u);
  EXPECT_EQ(scene.positions.size(), 3u);
  expect_color(scene.materials[0].transmission, {0.5f, 0.5f, 0.5f});
  EXPECT_EQ(scene.materials[0].ior, 1.0f);
  expect_color(scene.materials[1].transmission, {0, 1, 0});
  EXPECT_EQ(scene.materials[1].ior, 1.3f);
  expect_color(scene.materials[2].transmission, {0, 0, 0});
  expect_color(scene.materials[3].specular, {0, 0, 0});
  expect_color(scene.materials[4].diffuse, {1, 0, 0.5f});
  EXPECT_EQ(scene.materials[4].shininess, 1.0f);
  expect_color(scene.materials[5].diffuse, {0.25f, 0.25f, 0.25f});
}

TEST(Obj, lines) {
  const Folder folder;
  const auto file =
      folder.write("a.obj",
                   "# \xe4\xf6\r\nv\t0 0 0 1 0.5 0.5 # colour\r\n  v +1 .0 0e0\r\nv 0 \\\r\n 1 \\\r\n0\r\n"
                   "vp 1\r\nl 1 2\r\np 1\r\nf 1 2 3\r\nf 1 2\r\ncurv 0 1\r\ncurv 0 1\r\nf -3// -2/ 3");
  const char* before = std::setlocale(LC_ALL, nullptr);
  const std::string locale = before == nullptr ? "C" : before;
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const Scene scene = load_mesh(file);
  std::setlocale(LC_ALL, locale.c_str());
  EXPECT_EQ(scene.triangles.size(), 2u);
  EXPECT_EQ(scene.positions.size(), 3u);
  EXPECT_EQ(scene.positions[2], (Vec3{0, 1, 0}));
  EXPECT_TRUE(scene.normals.empty());
  EXPECT_TRUE(scene.texcoords.empty());
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_NE(scene.warnings[0].find("line 12: unknown statement 'curv'"), std::string::npos) << scene.warnings[0];
}

TEST(Obj, vertices_are_shared_by_equal_corners_only) {
  const Folder folder;
  const Scene scene = load_mesh(folder.write(
      "a.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5\nvt 1 1\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1/1 2/2 3/1/1\nf 1/1/1 2/2 3/1\n"));
  EXPECT_EQ(scene.positions.size(), 6u);
  EXPECT_EQ(scene.triangles[1].a, scene.triangles[0].a);
  EXPECT_NE(scene.triangles[1].b, scene.triangles[0].b);
  EXPECT_EQ(scene.triangles[2].b, scene.triangles[1].b);
  EXPECT_EQ(scene.triangles[2].c, scene.triangles[0].c);
}

TEST(Obj, what_is_missing_is_told) {
  const Folder folder;
  folder.write("in/b c.mtl", "newmtl m\nKd 1 0 0\nmap_Kd -s 2 2 -clamp on ../../none.png\nbogus 1\n");
  const auto file = folder.write("in/a.obj",
                                 "mtllib b c.mtl\nmtllib no.mtl other.mtl\nmtllib ../x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                 "f 1 2 3\nusemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\nusemtl n\nf 1 2 3\n");
  const Scene scene = load_mesh(file);
  ASSERT_EQ(scene.materials.size(), 2u);
  const u32 of_triangle[] = {0, 1, 0, 0};
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(scene.triangles[i].material, of_triangle[i]);
  EXPECT_EQ(scene.materials[1].diffuse, (Vec3{1, 0, 0}));
  EXPECT_EQ(scene.textures.size(), 1u);  // the checker
  EXPECT_TRUE(warned(scene, "a.obj, line 2: there is no material library 'no.mtl'"));
  EXPECT_TRUE(warned(scene, "a.obj, line 2: there is no material library 'other.mtl'"));
  EXPECT_TRUE(warned(scene, "a.obj, line 3: '../x.mtl' lies outside"));
  EXPECT_TRUE(warned(scene, "a.obj, line 10: material 'n' is not defined"));
  EXPECT_TRUE(warned(scene, "b c.mtl, line 3: option '-s'"));
  EXPECT_TRUE(warned(scene, "b c.mtl, line 3: option '-clamp'"));
  EXPECT_TRUE(warned(scene, "b c.mtl, line 3: '../../none.png' lies outside"));
  EXPECT_TRUE(warned(scene, "b c.mtl, line 4: unknown statement 'bogus'"));
  EXPECT_EQ(scene.warnings.size(), 8u);
}

TEST(Obj, images_lie_beside_the_library_that_names_them) {
  const Folder folder;
  folder.write("one/a.mtl", "newmtl a\nmap_Kd a.png\n");
  folder.write("one/a.png", "x");
  folder.write("two/b.mtl", "newmtl b\nKd 1 1 1\n");
  const auto file =
      folder.write("a.obj", "mtllib one/a.mtl\nmtllib two/b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  const Scene scene = load_mesh(file, {.decode = [](std::span<const u8>) { return Texture{"", 1, 1, {0}}; }});
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].texels.size(), 1u);
  EXPECT_TRUE(scene.warnings.empty());
}

struct Bad {
  const char* name;
  std::string content;
  std::string says;
};
void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::vector<Bad> bad_files() {
  std::string many = "f";
  for (int i = 0; i < 1001; ++i) many += " 1";
  return {
      {"high", kThree + "f 1 2 4\n", "line 4: vertex 4 is out of range: there are 3 so far"},
      {"low", kThree + "f 1 2 -4\n", "line 4: vertex -4 is out of range"},
      {"zero", kThree + "f 1 2 0\n", "line 4: vertex 0 is out of range"},
      {"huge", kThree + "f 1 2 99999999999999999999\n", "line 4: '99999999999999999999' is not an index"},
      {"text_index", kThree + "f 1 2 x\n", "line 4: 'x' is not an index"},
      {"no_index", kThree + "f 1 2 /1\n", "line 4: '' is not an index"},
      {"texcoord", kThree + "f 1/1 2 3\n", "line 4: texture coordinate 1 is out of range: there are 0"},
      {"normal", kThree + "vn 0 0 1\nf 1 2 3//-2\n", "line 5: normal -2 is out of range"},
      {"surplus", kThree + "vn 0 0 1\nf 1 2 3//1/1\n", "line 5: '1/1' is not an index"},
      {"nan", "v 0 0 0\nv 0 nan 0\n", "line 2: 'nan' is not a finite number"},
      {"infinite", "v 0 0 -1e999\n", "line 1: '-1e999' is not a finite number"},
      {"normal_nan", "vn 0 0 inf\n", "line 1: 'inf' is not a finite number"},
      {"texcoord_nan", "vt nan\n", "line 1: 'nan' is not a finite number"},
      {"comma", "v 0,5 0 0\n", "line 1: '0,5' is not a number"},
      {"short", "v 0 \\\n\n0\n", "line 1: a number is missing"},
      {"corners", kThree + many, "line 4: a polygon of 1001 corners; the most is 1000"},
      {"mtl_nan", "\nmtllib nan.mtl\n", "nan.mtl, line 2: 'Kd': 'nan' is not a finite number"},
      {"mtl_first", "mtllib first.mtl\n", "first.mtl, line 1: 'Kd': there is no newmtl before it"},
      {"mtl_short", "mtllib short.mtl\n", "short.mtl, line 2: 'Ns': a number is missing"},
      {"mtl_spectral", "mtllib spectral.mtl\n", "spectral.mtl, line 2: 'Kd': colours as 'spectral' are not supported"},
      {"mtl_image", "mtllib image.mtl\n", "image.mtl, line 2: 'map_Kd': the name of the image is missing"},
  };
}

class BadObj : public testing::TestWithParam<Bad> {};

TEST_P(BadObj, is_refused) {
  const Folder folder;
  folder.write("nan.mtl", "newmtl a\nKd 1 nan 1\n");
  folder.write("first.mtl", "Kd 1 1 1\n");
  folder.write("short.mtl", "newmtl a\nNs\n");
  folder.write("spectral.mtl", "newmtl a\nKd spectral file.rfl 1\n");
  folder.write("image.mtl", "newmtl a\nmap_Kd -s 1 1 1\n");
  const auto file = folder.write("bad.obj", GetParam().content);
  const std::string message = message_of([&] { load_mesh(file); });
  EXPECT_NE(message.find(file.string()), std::string::npos) << message;
  EXPECT_NE(message.find(GetParam().says), std::string::npos) << message;
}
INSTANTIATE_TEST_SUITE_P(, BadObj, testing::ValuesIn(bad_files()), [](const auto& each) { return each.param.name; });

TEST(Obj, too_many_triangles) {
  const Folder folder;
  std::string text = kThree;
  for (int i = 0; i < 11; ++i) text += "f 1 2 3\n";
  const auto file = folder.write("a.obj", text);
  const std::string message = message_of([&] { load_mesh(file, {.limits = {.triangles = 10}}); });
  EXPECT_NE(message.find("line 14: more than 10 triangles"), std::string::npos) << message;
}

/// Many vertices at one position must not make the search for an equal one long.
TEST(Obj, corners_that_differ_everywhere_take_linear_time) {
  const Folder folder;
  constexpr int kCount = 200'000;
  std::string text = kThree;
  for (int i = 0; i < kCount; ++i) text += "vt 0 " + std::to_string(i) + "\nf 1/-1 2/-1 3/-1\n";
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = load_mesh(folder.write("a.obj", text));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  EXPECT_EQ(scene.positions.size(), 3u * kCount);
}

TEST(Obj, originals) {
  const char* data = std::getenv("RAYWALK_SCENE_DATA");
  if (data == nullptr) GTEST_SKIP() << "RAYWALK_SCENE_DATA names no folder of original scene data";
  const std::pair<const char*, u64> counts[] = {
      {"conference/conference_partial.obj", 271088},
      {"buddha/buddha_100k.obj", 100000},
      {"obj_misc/stanford-bunny.obj", 69451},
      {"obj_misc/cornell_box.obj", 36},
      {"obj_misc/teapot.obj", 6320},
      {"obj_misc/spot.obj", 5856},
      {"obj_misc/cow.obj", 5804},
      {"obj_misc/fandisk.obj", 12946},
      {"obj_misc/suzanne.obj", 968},
  };
  for (const auto& [name, count] : counts) {
    if (!std::filesystem::exists(std::filesystem::path(data) / name)) continue;
    const Scene scene = load_mesh(std::filesystem::path(data) / name);
    EXPECT_EQ(scene.triangles.size(), count) << name;
    EXPECT_LE(scene.positions.size(), 3 * count) << name;
  }
}

}  // namespace
}  // namespace raywalk::test
