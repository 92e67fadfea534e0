// MGF: surfaces, transformations, arrays, includes and contexts.
#include <gtest/gtest.h>

#include "tests/scene/mgf_file.h"

namespace raywalk::test {
namespace {

void expect_near(Vec3 value, Vec3 expected) {
  EXPECT_NEAR(value.x, expected.x, 1e-5f);
  EXPECT_NEAR(value.y, expected.y, 1e-5f);
  EXPECT_NEAR(value.z, expected.z, 1e-5f);
}

TEST(Mgf, every_surface_has_its_count_and_material) {
  const Scene scene = load_mesh(mgf_sample("shapes.mgf"));
  EXPECT_TRUE(scene.warnings.empty());
  const size_t counts[] = {360, 40, 40, 20, 40, 20, 800, 12, 2, 1};
  ASSERT_EQ(scene.materials.size(), std::size(counts));
  size_t at = 0;
  for (u32 material = 0; material < std::size(counts); ++material) {
    for (size_t i = 0; i < counts[material]; ++i, ++at) {
      ASSERT_LT(at, scene.triangles.size());
      ASSERT_EQ(scene.triangles[at].material, material) << "triangle " << at;
    }
    if (material < 9) {
      EXPECT_NEAR(scene.materials[material].diffuse.x, 0.1f * static_cast<float>(material + 1), 1e-6f);
    }
  }
  EXPECT_EQ(at, scene.triangles.size());
  // The prism grows away from where its base looks, and is closed; so is the torus.
  EXPECT_NEAR(volume_of(scene, 1320, 12), 3.0, 1e-5);
  EXPECT_NEAR(volume_of(scene, 0, 360), 4.0 / 3 * 3.14159 * 3.375, 1.0);
  EXPECT_NEAR(volume_of(scene, 520, 800), 2 * 3.14159 * 3.14159 * 2, 2.0);
  Box prism;
  for (size_t i = 1320; i < 1332; ++i) {
    for (const Vec3 corner : corners_of(scene, i)) prism.add(corner);
  }
  expect_near(prism.lo, {0, 0, 0});
  expect_near(prism.hi, {1, 1, 3});
  expect_near(area_of(scene, 1332) + area_of(scene, 1333), {0, 0, 1});
}

TEST(Mgf, spheres_are_tessellated_as_asked) {
  ImportSettings settings;
  settings.sphere_slices = 15;
  settings.sphere_stacks = 14;
  EXPECT_EQ(mgf_scene("v a =\np 0 0 0\nsph a 1\n", settings).triangles.size(), 390u);
}

TEST(Mgf, holes_are_left_open) {
  const Scene scene = load_mesh(mgf_sample("hole.mgf"));
  ASSERT_EQ(scene.triangles.size(), 8u);
  float area = 0.0f;
  for (size_t i = 0; i < 8; ++i) {
    EXPECT_GE(area_of(scene, i).z, 0.0f);
    area += area_of(scene, i).z;
    // No triangle covers the middle of the window.
    const auto [a, b, c] = corners_of(scene, i);
    const Vec3 middle{3.0f, 2.5f, 5.0f};
    const bool covers =
        cross(b - a, middle - a).z > 0 && cross(c - b, middle - b).z > 0 && cross(a - c, middle - c).z > 0;
    EXPECT_FALSE(covers);
  }
  EXPECT_FLOAT_EQ(area, 24.0f - 2.0f);
}

TEST(Mgf, normals_of_vertices_are_kept_and_turned) {
  const Scene scene =
      mgf_scene("v a =\np 0 0 0\nn 0 0 5\nv b = a\np 1 0 0\nv c =\np 0 1 0\nxf -s 3 -rx 90\nf a b c\nxf\n");
  ASSERT_EQ(scene.normals.size(), 3u);
  expect_near(scene.normals[0], {0, -1, 0});
  expect_near(scene.normals[1], {0, -1, 0});
  expect_near(scene.normals[2], {0, 0, 0});
  expect_near(scene.positions[2], {0, 0, 3});
}

TEST(Mgf, transformations_go_from_left_to_right_and_from_inside_out) {
  const Scene scene = mgf_scene(kMgfSquare + "xf -t 100 0 0\nxf -t 1 0 0 -rz 90 -s 2\nf a b c\nxf\nxf\nf a b c\n");
  // (0, 0, 0) -> (1, 0, 0) -> (0, 1, 0) -> (0, 2, 0) -> (100, 2, 0).
  expect_near(scene.positions[0], {100, 2, 0});
  expect_near(scene.positions[1], {100, 4, 0});
  expect_near(scene.positions[3], {0, 0, 0});
}

TEST(Mgf, they_apply_where_geometry_is_used) {
  const Scene scene = mgf_scene("xf -t 5 0 0\n" + kMgfSquare + "xf\nxf -t 0 0 7\nf a b c\nxf\n");
  expect_near(scene.positions[0], {0, 0, 7});
}

TEST(Mgf, each_rotation_and_mirror) {
  const struct {
    const char* arguments;
    Vec3 b, c;  // of (1, 0, 0) and (1, 1, 0)
  } cases[] = {{"-rx 90", {1, 0, 0}, {1, 0, 1}},        {"-ry 90", {0, 0, -1}, {0, 1, -1}},
               {"-rz 90", {0, 1, 0}, {-1, 1, 0}},       {"-mx", {-1, 0, 0}, {-1, 1, 0}},
               {"-my", {1, 0, 0}, {1, -1, 0}},          {"-mz", {1, 0, 0}, {1, 1, 0}},
               {"-s -1", {-1, 0, 0}, {-1, -1, 0}},      {"-i 3 -t 1 0 0", {4, 0, 0}, {4, 1, 0}},
               {"-i 0 -t 1 0 0", {1, 0, 0}, {1, 1, 0}}, {"-i 2 -rz 45 -i 1 -t 0 0 1", {0, 1, 1}, {-1, 1, 1}}};
  for (const auto& one : cases) {
    const Scene scene = mgf_scene(kMgfSquare + "xf " + one.arguments + "\nf a b c\nxf\n");
    SCOPED_TRACE(one.arguments);
    ASSERT_EQ(scene.positions.size(), 3u);
    // A mirror reverses the corners, so that the front stays the front.
    const bool mirrored = std::string(one.arguments).starts_with("-m") || std::string(one.arguments) == "-s -1";
    expect_near(scene.positions[1], one.b);
    expect_near(scene.positions[mirrored ? 0 : 2], one.c);
  }
}

TEST(Mgf, mirrored_solids_still_face_outwards) {
  for (const char* surface : {"sph o 1", "torus o 1 2", "prism a d c b 1"}) {
    const Scene scene = mgf_scene(kMgfSquare + "v o =\np 0 0 0\nn 0 0 1\nxf -mx -rz 30\n" + surface + "\nxf\n");
    EXPECT_GT(volume_of(scene, 0, scene.triangles.size()), 0.1) << surface;
    for (size_t i = 0; i < scene.triangles.size() && !scene.normals.empty(); ++i) {
      EXPECT_GT(dot(area_of(scene, i), scene.normals[scene.triangles[i].b]), 0.0f) << surface;
    }
  }
  const Scene inside = mgf_scene(kMgfSquare + "prism a d c b -1\nsph a -1\n");
  EXPECT_NEAR(volume_of(inside, 0, 12), -1.0, 1e-5);
  EXPECT_LT(volume_of(inside, 12, 360), -3.0);
}

TEST(Mgf, arrays_nest) {
  const Scene scene =
      mgf_scene(kMgfSquare + "xf -t 0 0 9 -a 2 -t 10 0 0 -a 3 -t 0 10 0\nxf -a 2 -s 0.5\nf a b c\nxf\nxf\nf a b c\n");
  ASSERT_EQ(scene.triangles.size(), 13u);
  size_t at = 0;
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int half = 0; half < 2; ++half, ++at) {
        expect_near(scene.positions[3 * at], {10.0f * x, 10.0f * y, 9});
        expect_near(scene.positions[3 * at + 1], {10.0f * x + (half == 0 ? 1.0f : 0.5f), 10.0f * y, 9});
      }
    }
  }
  expect_near(scene.positions[36], {0, 0, 0});
}

TEST(Mgf, includes_are_found_beside_the_including_file) {
  ImportSettings settings;
  settings.root = mgf_sample("");
  const Scene scene = load_mesh(mgf_sample("includes.mgf"), settings);
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.triangles.size(), 2u * 5 + 1);
  const Vec3 first[] = {{10, 0, 0}, {10, 0, 1}, {0, 0, 0}, {10, 0, 0}, {20, 0, 0}};
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_GT(area_of(scene, 2 * i).z, 0.0f);
    Box box;
    for (size_t k = 2 * i; k < 2 * i + 2; ++k) {
      for (const Vec3 corner : corners_of(scene, k)) box.add(corner);
    }
    expect_near(box.lo, first[i]);
  }
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(Mgf, contexts_are_copied_selected_and_reset) {
  const Scene scene = mgf_scene(kMgfSquare +
                                "m one =\nrd 0.25\nm two = one\nrd 0.5\nm one\nf a b c\nm two\nf a b c\nm\nf a b c\n"
                                "m two =\nf a b c\nm one = one\nf a b c\nrd 0.75\nf a b c\n");
  ASSERT_EQ(scene.triangles.size(), 6u);
  const float expected[] = {0.25f, 0.5f, 0.0f, 0.0f, 0.25f, 0.75f};
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_FLOAT_EQ(scene.materials[scene.triangles[i].material].diffuse.x, expected[i]) << i;
  }
  EXPECT_EQ(scene.materials.size(), 4u) << "equal ones are one";
  const Scene vertices = mgf_scene(kMgfSquare + "v e = a\np 0 0 3\nv\np 5 5 5\nf a b e\nv e\np 0 0 4\nf a b e\n");
  expect_near(vertices.positions[2], {0, 0, 3});
  expect_near(vertices.positions[5], {0, 0, 4});
}

TEST(Mgf, lines_may_be_continued_and_end_like_those_of_dos) {
  const Scene scene =
      mgf_scene("v a =\r\n\tp 0 0 0\r\nv b =\r\np 1\\\r\n 0 \\\r\n0\r\nv c =\np 0 \\\n\\\n1 0\n  # f a\n\nf a b\\\n c");
  ASSERT_EQ(scene.triangles.size(), 1u);
  expect_near(scene.positions[1], {1, 0, 0});
  expect_near(scene.positions[2], {0, 1, 0});
}

TEST(Mgf, what_is_unknown_or_left_out_is_a_warning_with_its_line) {
  const Scene scene = mgf_scene(kMgfSquare + "/stray\nies lamp.ies\no\no open\nf a b c\n");
  EXPECT_EQ(scene.triangles.size(), 1u);
  ASSERT_EQ(scene.warnings.size(), 4u);
  EXPECT_NE(scene.warnings[0].find("a.mgf, line 9: '/stray' is no statement"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("a.mgf, line 10: the luminaire 'lamp.ies'"), std::string::npos);
  EXPECT_NE(scene.warnings[2].find("a.mgf, line 11: this 'o' closes no object"), std::string::npos);
  EXPECT_NE(scene.warnings[3].find("1 objects are not closed"), std::string::npos);
}

}  // namespace
}  // namespace raywalk::test
