// AFF files that must be read: every statement, with what it becomes.
#include <algorithm>
#include <clocale>

#include "server/scene/formats/formats.h"
#include "tests/scene/aff_file.h"

namespace raywalk::test {
namespace {

class EveryStatement : public testing::Test {
 protected:
  // The order of the file: p 5 (3 triangles), pp, tt, ttp, tpa, s, c, c, m (2), corner, fine (2), corner in xs, corner
  // in x, and one that is hidden.
  static constexpr size_t kSphere = 360, kCylinder = 40, kPointed = 20;
  static constexpr size_t kSmooth = 3, kFlatTextured = 4, kSmoothTextured = 5, kAnimated = 6, kCurved = 7;
  static constexpr size_t kMesh = kCurved + kSphere + kCylinder + kPointed;
  static constexpr size_t kIncluded = kMesh + 2, kFine = kIncluded + 1, kFixed = kFine + 2, kMoved = kFixed + 1;

  const Scene scene = load_mesh(aff_samples() / "every.aff", aff_settings());
};

TEST_F(EveryStatement, counts) {
  EXPECT_EQ(scene.triangles.size(), kMoved + 1);
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
  EXPECT_NO_THROW(pack(scene));
}

TEST_F(EveryStatement, surroundings) {
  EXPECT_EQ(scene.background, (Vec3{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(scene.ambient, (Vec3{0.5f, 0.6f, 0.7f}));
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].position, (Vec3{1, 2, 3}));
  EXPECT_EQ(scene.lights[0].intensity, (Vec3{1, 1, 1}));
  EXPECT_EQ(scene.lights[1].intensity, (Vec3{0.5f, 0.25f, 0.125f}));
  expect_near(scene.lights[2].position, {1, 9, 0});
}

TEST_F(EveryStatement, fills) {
  const Material& f = scene.materials.at(scene.triangles[0].material);
  expect_near(f.diffuse, {0.8f, 0.4f, 0.2f});
  expect_near(f.ambient, {0.1f, 0.05f, 0.025f});
  EXPECT_EQ(f.specular, (Vec3{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(f.reflection, (Vec3{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(f.transmission, (Vec3{0, 0, 0}));
  EXPECT_EQ(f.shininess, 30.0f);
  EXPECT_EQ(f.ior, 1.0f);
  EXPECT_EQ(f.texture, kNoTexture);

  const Material& fm = scene.materials.at(scene.triangles[kSmooth].material);
  EXPECT_EQ(fm.ambient, (Vec3{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(fm.diffuse, (Vec3{0.4f, 0.5f, 0.6f}));
  EXPECT_EQ(fm.specular, (Vec3{0.5f, 0.25f, 0.125f}));
  EXPECT_EQ(fm.reflection, (Vec3{0.25f, 0.25f, 0.125f})) << "no more than what is not let through";
  EXPECT_EQ(fm.transmission, (Vec3{0.75f, 0.75f, 0.75f}));
  EXPECT_EQ(fm.shininess, 80.0f);
  EXPECT_EQ(fm.ior, 1.5f);
}

TEST_F(EveryStatement, one_material_a_pair_of_fill_and_texture) {
  EXPECT_EQ(scene.materials.size(), 3u);
  const u32 textured = scene.triangles[kFlatTextured].material;
  EXPECT_EQ(scene.triangles[kSmoothTextured].material, textured);
  EXPECT_EQ(scene.triangles[kMesh].material, textured);
  EXPECT_EQ(scene.materials[textured].texture, 0u);
  EXPECT_EQ(scene.triangles[kIncluded].material, scene.triangles[kSmooth].material);
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].width, 2u);
}

TEST_F(EveryStatement, polygons_and_triangles) {
  for (size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_EQ(normal_of(scene, i, c), (Vec3{0, 0, 0}));
  }
  EXPECT_EQ(position_of(scene, kSmooth, 1), (Vec3{1, 0, 1}));
  EXPECT_EQ(normal_of(scene, kSmooth, 1), (Vec3{0, 0, 1}));
  EXPECT_EQ(position_of(scene, kFlatTextured, 2), (Vec3{0, 1, 2}));
  const TexCoord second = scene.texcoords[corner_of(scene, kFlatTextured, 1)];
  EXPECT_EQ(second.s, 1.0f);
  EXPECT_EQ(second.t, 0.25f);
  EXPECT_EQ(normal_of(scene, kSmoothTextured, 1), (Vec3{0, 1, 0}));
}

TEST_F(EveryStatement, animated_triangle_at_rest) {
  expect_near(position_of(scene, kAnimated, 0), {0, 0, 5});
  expect_near(position_of(scene, kAnimated, 2), {0, 1, 5});
  const float half = 0.70710678f;
  expect_near(normal_of(scene, kAnimated, 0), {0, half, half});
}

TEST_F(EveryStatement, curved_surfaces) {
  for (size_t i = kCurved; i < kCurved + kSphere; ++i) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 from_centre = position_of(scene, i, c) - Vec3{10, 0, 0};
      EXPECT_NEAR(length(from_centre), 0.5f, 1e-5f);
      expect_near(normal_of(scene, i, c), 2.0f * from_centre, 1e-4f);
    }
  }
  Box cylinder;
  for (size_t i = kCurved + kSphere; i < kCurved + kSphere + kCylinder; ++i) {
    for (int c = 0; c < 3; ++c) cylinder.add(position_of(scene, i, c));
  }
  EXPECT_EQ(cylinder.lo.y, 0.0f);
  EXPECT_EQ(cylinder.hi.y, 2.0f);
  EXPECT_NEAR(cylinder.hi.x, -9.5f, 1e-5f);
}

TEST_F(EveryStatement, mesh_indices_are_grouped_by_attribute) {
  EXPECT_EQ(position_of(scene, kMesh, 2), (Vec3{1, 1, -1}));
  EXPECT_EQ(position_of(scene, kMesh + 1, 2), (Vec3{0, 1, -1}));
  EXPECT_EQ(normal_of(scene, kMesh, 0), (Vec3{0, 0, 1}));
  EXPECT_EQ(scene.texcoords[corner_of(scene, kMesh + 1, 2)].t, 1.0f);
  EXPECT_EQ(corner_of(scene, kMesh, 0), corner_of(scene, kMesh + 1, 0)) << "equal corners share a vertex";
}

TEST_F(EveryStatement, includes_by_level_of_detail) {
  EXPECT_EQ(position_of(scene, kIncluded, 1), (Vec3{1, 0, 0}));
  EXPECT_EQ(position_of(scene, kFine, 0).z, -2.0f);
}

TEST_F(EveryStatement, transforms) {
  // Twice as large, a quarter turn around z, then 10 along x.
  expect_near(position_of(scene, kFixed, 0), {10, 0, 0});
  expect_near(position_of(scene, kFixed, 1), {10, 2, 0});
  expect_near(position_of(scene, kFixed, 2), {8, 0, 0});
  // Inside it 5 along z; around that thrice as wide, a quarter turn and 1 along x.
  expect_near(position_of(scene, kMoved, 0), {10, 2, 10});
  expect_near(position_of(scene, kMoved, 1), {4, 2, 10});
  expect_near(position_of(scene, kMoved, 2), {10, 0, 10});
}

TEST_F(EveryStatement, camera_path) {
  ASSERT_TRUE(scene.has_camera_path);
  EXPECT_TRUE(scene.cameras.empty());
  EXPECT_EQ(scene.camera_path.frames, 400u);
  const CameraPose first = pose_at(scene.camera_path, 0, 5), middle = pose_at(scene.camera_path, 2, 5),
                   last = pose_at(scene.camera_path, 4, 5);
  expect_near(first.eye, {0, 0, 0});
  expect_near(normalized(first.target - first.eye), {0, 0, -1});
  expect_near(middle.eye, {5, 0, 0});
  const float half = 0.70710678f;
  expect_near(normalized(middle.target - middle.eye), {-half, 0, -half});
  expect_near(last.eye, {10, 0, 0});
  expect_near(normalized(last.target - last.eye), {-1, 0, 0});
  expect_near(last.up, {0, 1, 0});
  EXPECT_EQ(last.vertical_fov_deg, 50.0f);
  expect_near(pose_at(scene.camera_path, 0, 1).eye, {0, 0, 0});
}

TEST(Aff, without_animation_the_view_is_a_camera) {
  const Scene scene = load_mesh(aff_samples() / "view.nff");
  EXPECT_FALSE(scene.has_camera_path);
  EXPECT_EQ(scene.camera_path.shape.index(), 0u) << "an orbit";
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].pose.eye, (Vec3{0, 0, 9}));
  EXPECT_EQ(scene.cameras[0].pose.vertical_fov_deg, 30.0f);
  EXPECT_EQ(scene.triangles.size(), 360u);
}

TEST(Aff, settings_say_how_fine_curves_are) {
  const Folder folder;
  const auto file = folder.write("a.aff", "s 0 0 0 1\nc 0 0 0 1 0 1 0 1\nc 0 0 0 1 0 1 0 1\n");
  ImportSettings settings = aff_settings();
  settings.sphere_slices = 15;
  settings.sphere_stacks = 14;
  settings.cone_slices = 8;
  EXPECT_EQ(load_mesh(file, settings).triangles.size(), 390u + 2 * 16u);
  settings.cone_slices = 0;
  const Scene scene = load_mesh(file, settings);
  EXPECT_EQ(scene.triangles.size(), 390u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("2 cones are left out"), std::string::npos);
}

TEST(Aff, is_recognised_by_its_view) {
  const auto begins = [](const std::string& head) {
    return (*std::find_if(formats().begin(), formats().end(),
                          [](const Format* f) { return std::string_view(f->name) == "AFF"; }))
        ->begins({reinterpret_cast<const u8*>(head.data()), head.size()});
  };
  EXPECT_TRUE(begins("v\nfrom 0 0 1\n"));
  EXPECT_TRUE(begins("# NFF\n%\r\nb 0.5 0.5 1.0\r\nam 1 1 1\nl 0 1 2\na 0 1 2\nv from -1 .5 1e3"));
  for (const char* other :
       {"", "v", "v from", "v a =\n p 0 0 0", "v 0 0 1\nf 1 2 3", "#Inventor V2.1 ascii\nSeparator {}",
        "ply\nformat ascii 1.0\n", "b x\nv from 0 0 0", "i file.mgf", "{\"asset\":{}}"}) {
    EXPECT_FALSE(begins(other)) << other;
  }
}

TEST(Aff, what_one_name_moves_keeps_still_when_it_has_no_keys) {
  const Scene scene = read_aff("x a { p 3 0 0 0 1 0 0 0 1 0 x a { p 3 0 0 0 2 0 0 0 1 0 } }\nla b 1 2 3\n");
  EXPECT_EQ(position_of(scene, 1, 1), (Vec3{2, 0, 0}));
  EXPECT_EQ(scene.lights[0].position, (Vec3{1, 2, 3}));
  ASSERT_EQ(scene.warnings.size(), 2u) << "one a name";
  EXPECT_NE(scene.warnings[0].find("test.aff, line 1"), std::string::npos);
  EXPECT_NE(scene.warnings[0].find("'a'"), std::string::npos);
}

TEST(Aff, keys_that_go_back_are_left_out) {
  const std::string key = " 0 0 0  0 0 0 ";
  const Scene scene = read_aff("x a { p 3 0 0 0 1 0 0 0 1 0 }\nk a { transl 6 -2" + key + "-1" + key +
                               "-3 9 9 9 0 0 0 1" + key + "0.5 9 9 9 0 0 0 2" + key + "}");
  EXPECT_EQ(position_of(scene, 0, 1), (Vec3{1, 0, 0}));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("line 2: 2 keys of 'a'"), std::string::npos);
}

TEST(Aff, animated_triangles_are_clamped_to_their_keys) {
  const std::string shape = " 0 0 1  0 0 1   1 0 1  0 0 1   0 1 1  0 0 1 ",
                    other = " 5 5 5 0 0 1 6 5 5 0 0 1 5 6 5 0 0 1 ";
  for (const std::string& keys :
       {"1 0" + shape, "1 7" + shape, "1 -7" + shape, "2 3" + shape + "4" + other, "2 -4" + other + "-3" + shape,
        "3 -1" + other + "0" + shape + "1" + other, "2 0" + shape + "0" + other}) {
    EXPECT_EQ(position_of(read_aff("tpa " + keys), 0, 2), (Vec3{0, 1, 1})) << keys;
  }
}

TEST(Aff, flat_scales_and_mirrors_keep_normals_right) {
  const std::string mesh = "{ pp 3  0 0 0 0 0 1  1 0 0 0 0 1  0 1 0 0 0 1 }";
  EXPECT_EQ(normal_of(read_aff("xs 1 1 0  0 0 1 0  0 0 0" + mesh), 0, 0), (Vec3{0, 0, 1}));
  EXPECT_EQ(normal_of(read_aff("xs 1 1 -2  0 0 1 0  0 0 0" + mesh), 0, 0), (Vec3{0, 0, -1}));
  EXPECT_EQ(normal_of(read_aff("xs -3 1 2  0 0 0 77  0 0 0" + mesh), 0, 0), (Vec3{0, 0, 1}));
}

TEST(Aff, unknown_statements_are_skipped_with_a_warning) {
  const Scene scene = read_aff(
      "frobnicate 1 2 \xe4 { in one line }\np 3 0 0 0 1 0 0 0 1 0\nblob\n1 2 3\n4 5 6\nbraced\n1\n{ a { b }\n}\n"
      "p 3 0 0 0 1 0 0 0 1 0\n");
  EXPECT_EQ(scene.triangles.size(), 2u);
  ASSERT_EQ(scene.warnings.size(), 3u);
  EXPECT_NE(scene.warnings[0].find("test.aff, line 1: unknown statement 'frobnicate'"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("line 3"), std::string::npos);
  EXPECT_NE(scene.warnings[2].find("line 6"), std::string::npos);
}

TEST(Aff, missing_textures_are_a_warning_each) {
  const std::string triangle = " 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1\n";
  const Scene scene = read_aff("tt no.ppm" + triangle + "tt no.ppm" + triangle + "tt ../out.ppm" + triangle);
  EXPECT_EQ(scene.triangles.size(), 3u);
  EXPECT_EQ(scene.warnings.size(), 2u);
  ASSERT_EQ(scene.textures.size(), 1u) << "the checker";
  EXPECT_EQ(scene.materials.at(scene.triangles[2].material).texture, 0u);
}

TEST(Aff, comments_and_braces_end_words_and_the_locale_does_not_matter) {
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  const Scene scene = read_aff(
      "fm 1 1 1 .5 .5 .5%all\n0 0 0 0 0 0#\nxs 1 1 1 0 0 1 0 0.5 0 0{p 3 0 0 0 1.5 0 0 0 1 0}p 3 "
      "0 0 0 1e-50 0 0 0 1 0");
  std::setlocale(LC_NUMERIC, "C");
  EXPECT_EQ(position_of(scene, 0, 1), (Vec3{2, 0, 0}));
  EXPECT_EQ(position_of(scene, 1, 1), (Vec3{0, 0, 0}));
}

}  // namespace
}  // namespace raywalk::test
