// Open Inventor and VRML 1.0: what must be read.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "server/scene/importer.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

Scene load_text(const std::string& body, const std::string& header = "#Inventor V2.1 ascii\n") {
  const Folder folder;
  return load_mesh(folder.write("a.iv", header + body));
}

void expect_near(Vec3 a, Vec3 b) {
  for (u32 i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-5) << "component " << i;
}
void expect_box(const Scene& scene, Vec3 lo, Vec3 hi) {
  expect_near(bounds_of(scene).lo, lo);
  expect_near(bounds_of(scene).hi, hi);
}

Vec3 diffuse_of(const Scene& scene, size_t triangle) {
  return scene.materials[scene.triangles[triangle].material].diffuse;
}

const std::string kSquare = "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } ";
const std::string kColors = "Material { diffuseColor [ 1 0 0, 0 1 0, 0 0 1, 1 1 0 ] } ";

TEST(Inventor, sample) {
  const Scene scene = load_mesh(scenes_dir().parent_path() / "tests/scene/data/inventor/pavilion.iv");
  EXPECT_EQ(scene.warnings, std::vector<std::string>());
  ASSERT_EQ(scene.triangles.size(), 4u * 80u + 2u + 4u);
  expect_box(scene, {-3, 0, -3}, {3, 3, 3});
  ASSERT_EQ(scene.materials.size(), 1u + 1u + 4u);
  expect_near(scene.materials[0].diffuse, {0.8f, 0.8f, 0.7f});
  EXPECT_EQ(scene.materials[0].shininess, 64.0f);
  expect_near(diffuse_of(scene, 322), {0.75f, 0, 0});
  expect_near(diffuse_of(scene, 325), {0.75f, 0.75f, 0});
  expect_near(scene.materials[5].transmission, {0.25f, 0.25f, 0.25f});

  // Rows of an inline image run bottom up; the scene's run top down.
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].texels, (std::vector<u32>{0xff0000, 0xffffff, 0x0000ff, 0x00ff00}));
  const TriangleIndices floor = scene.triangles[320];
  EXPECT_EQ(scene.materials[floor.material].texture, 0u);
  for (const u32 v : {floor.a, floor.b, floor.c}) {
    EXPECT_FLOAT_EQ(scene.texcoords[v].s, (scene.positions[v].x + 3) / 6);
    EXPECT_FLOAT_EQ(scene.texcoords[v].t, (scene.positions[v].z + 3) / 6);
  }

  ASSERT_EQ(scene.lights.size(), 2u);
  expect_near(scene.lights[0].position, {4, 6, 4});
  expect_near(scene.lights[0].intensity, {0.5f, 0.25f, 0.125f});
  EXPECT_GT(scene.lights[1].position.y, 500.0f);
  EXPECT_NEAR(scene.lights[1].position.x, 0.0f, 1e-3);
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].name, "view");
  expect_near(scene.cameras[0].pose.eye, {0, 2, 10});
  expect_near(scene.cameras[0].pose.target, {0, 2, 0});
  EXPECT_NEAR(scene.cameras[0].pose.vertical_fov_deg, 45.0f, 1e-3);
}

TEST(Inventor, solids) {
  const Scene sphere = load_text("Sphere { radius 2 }");
  EXPECT_EQ(sphere.triangles.size(), 360u);
  expect_box(sphere, {-2, -2, -2}, {2, 2, 2});
  for (size_t i = 0; i < sphere.positions.size(); ++i) expect_near(sphere.normals[i], sphere.positions[i] * 0.5f);

  const Scene cube = load_text("Cube { width 1 height 2 depth 3 }");
  EXPECT_EQ(cube.triangles.size(), 12u);
  expect_box(cube, {-0.5f, -1, -1.5f}, {0.5f, 1, 1.5f});
  for (const TriangleIndices& t : cube.triangles) {
    const Vec3 a = cube.positions[t.a];
    EXPECT_GT(dot(cross(cube.positions[t.b] - a, cube.positions[t.c] - a), cube.normals[t.a]), 0.0f);
  }
  const Scene cone = load_text("Cone { bottomRadius 3 height 4 }");
  EXPECT_EQ(cone.triangles.size(), 80u);
  expect_box(cone, {-3, -2, -3}, {3, 2, 3});
  EXPECT_EQ(load_text("Cylinder { }").triangles.size(), 160u);
  EXPECT_EQ(load_text("Cylinder { parts (SIDES | TOP) }").triangles.size(), 120u);
  EXPECT_EQ(load_text("Cylinder { parts BOTTOM }").triangles.size(), 40u);
  const Scene parts = load_text(kColors + "MaterialBinding { value PER_PART } Cylinder { }");
  expect_near(diffuse_of(parts, 0), {1, 0, 0});
  expect_near(diffuse_of(parts, 80), {0, 1, 0});
  expect_near(diffuse_of(parts, 120), {0, 0, 1});
}

/// No triangle of a textured solid may span the seam backwards.
TEST(Inventor, texture_of_a_sphere_runs_on_over_the_seam) {
  const Scene scene = load_text("Texture2 { image 1 1 3 0xffffff } Sphere { }");
  for (const TriangleIndices& t : scene.triangles) {
    const float s[] = {scene.texcoords[t.a].s, scene.texcoords[t.b].s, scene.texcoords[t.c].s};
    for (const float other : s) EXPECT_LE(std::abs(other - s[0]), 0.051f);
  }
}

TEST(Inventor, transforms) {
  expect_box(load_text("Translation { translation 1 2 3 } Scale { scaleFactor 2 1 1 } Cube { }"), {-1, 1, 2},
             {3, 3, 4});
  expect_box(load_text("MatrixTransform { matrix 0 1 0 0 -1 0 0 0 0 0 1 0 10 20 30 1 } Cube { width 4 }"), {9, 18, 29},
             {11, 22, 31});
  expect_box(load_text("Rotation { rotation 0 0 7 1.5707963 } Cube { width 4 }"), {-1, -2, -1}, {1, 2, 1});
  expect_box(load_text("Rotation { rotation 0 0 0 1 } Cube { }"), {-1, -1, -1}, {1, 1, 1});
  expect_box(load_text("RotationXYZ { axis Z angle 1.5707963 } Cube { width 4 }"), {-1, -2, -1}, {1, 2, 1});
  // About the point (1, 0, 0): scaled, turned, moved.
  expect_box(
      load_text("Transform { translation 0 5 0 rotation 0 0 1 1.5707963 scaleFactor 2 1 1 center 1 0 0 } Cube { }"),
      {0, 1, -1}, {2, 5, 1});
  // A mirror keeps normals outwards.
  const Scene mirrored = load_text("Scale { scaleFactor -1 2 1 } Translation { translation 2 0 0 } Sphere { }");
  for (size_t i = 0; i < mirrored.positions.size(); ++i) {
    const Vec3 p = mirrored.positions[i] - Vec3{-2, 0, 0};
    expect_near(mirrored.normals[i], normalized(Vec3{p.x, p.y / 4, p.z}));
  }
}

TEST(Inventor, state_of_groups) {
  const std::string move = "{ Translation { translation 5 0 0 } BaseColor { rgb 1 0 0 } } Cube { }";
  const Scene separator = load_text("Separator " + move), group = load_text("Group " + move);
  expect_box(separator, {-1, -1, -1}, {1, 1, 1});
  expect_near(diffuse_of(separator, 0), {0.8f, 0.8f, 0.8f});
  expect_box(group, {4, -1, -1}, {6, 1, 1});
  const Scene transforms_only = load_text("TransformSeparator " + move);
  expect_box(transforms_only, {-1, -1, -1}, {1, 1, 1});
  expect_near(diffuse_of(transforms_only, 0), {1, 0, 0});

  const std::string choices = " Cube { } Sphere { } }";
  EXPECT_EQ(load_text("Switch {" + choices).triangles.size(), 0u);
  EXPECT_EQ(load_text("Switch { whichChild 0" + choices).triangles.size(), 12u);
  EXPECT_EQ(load_text("Switch { whichChild -3" + choices).triangles.size(), 372u);
  EXPECT_EQ(load_text("Switch { whichChild 1 Cone { } Switch { whichChild -2" + choices + "}").triangles.size(), 360u);
  EXPECT_EQ(load_text("LOD { range [ 1 ] Cube { } Sphere { } }").triangles.size(), 12u);
  EXPECT_EQ(load_text("DrawStyle { style INVISIBLE } Cube { }").triangles.size(), 0u);
}

TEST(Inventor, define_and_use) {
  const Scene scene = load_text("DEF a Cube { } Translation { translation 4 0 0 } USE a DEF a Cone { } USE a");
  EXPECT_EQ(scene.triangles.size(), 12u + 12u + 80u + 80u);
  expect_box(scene, {-1, -1, -1}, {5, 1, 1});
  EXPECT_EQ(load_text("DEF a BaseColor { rgb 1 0 0 } BaseColor { rgb 0 1 0 } USE a Cube { }").materials[0].diffuse,
            (Vec3{1, 0, 0}));
}

TEST(Inventor, ignored_fields_and_connections) {
  expect_near(diffuse_of(load_text("BaseColor { rgb 1 0 0 } BaseColor { rgb 0 1 0 ~ } Cube { }"), 0), {1, 0, 0});
  const Scene scene = load_text("Rotation { rotation 0 0 1 0 = Engine { f [ 1, { } ] } . outRotation } Cube { }");
  EXPECT_EQ(scene.triangles.size(), 12u);
}

TEST(Inventor, material_bindings) {
  const std::string faces = "IndexedFaceSet { coordIndex [ 0 1 2 -1 0 2 3 ] materialIndex [ 3 2 1 -1 2 1 0 ] }";
  const auto colors = [&](const std::string& binding) {
    const Scene scene = load_text(kColors + kSquare + "MaterialBinding { value " + binding + " }" + faces);
    return std::pair(diffuse_of(scene, 0), diffuse_of(scene, 1));
  };
  const Vec3 red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, yellow{1, 1, 0};
  EXPECT_EQ(colors("OVERALL"), std::pair(red, red));
  EXPECT_EQ(colors("DEFAULT"), std::pair(red, red));
  EXPECT_EQ(colors("PER_FACE"), std::pair(red, green));
  EXPECT_EQ(colors("PER_PART"), std::pair(red, green));
  EXPECT_EQ(colors("PER_FACE_INDEXED"), std::pair(yellow, blue));
  EXPECT_EQ(colors("PER_VERTEX"), std::pair(red, yellow));
  EXPECT_EQ(colors("PER_VERTEX_INDEXED"), std::pair(yellow, blue));
}

TEST(Inventor, normal_bindings) {
  const auto normals = [](const std::string& binding, const std::string& more = "") {
    return load_text("Normal { vector [ 1 0 0, 0 2 0, 0 0 3, -1 0 0, 0 -1 0, 0 0 -1 ] } NormalBinding { value " +
                     binding + " }" + kSquare + "IndexedFaceSet { coordIndex [ 0 1 2 -1 0 2 3 -1 ] " + more + " }")
        .normals;
  };
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(normals("OVERALL"), (std::vector<Vec3>{x, x, x, x, x, x}));
  EXPECT_EQ(normals("PER_FACE"), (std::vector<Vec3>{x, x, x, y, y, y}));
  EXPECT_EQ(normals("PER_FACE_INDEXED", "normalIndex [ 2, 0 ]"), (std::vector<Vec3>{z, z, z, x, x, x}));
  EXPECT_EQ(normals("PER_VERTEX"), (std::vector<Vec3>{x, y, z, -x, -y, -z}));
  EXPECT_EQ(normals("PER_VERTEX_INDEXED"), (std::vector<Vec3>{x, y, z, x, z, -x}));
  EXPECT_EQ(normals("DEFAULT", "normalIndex [ 2 2 2 -1 1 1 1 -1 ]"), (std::vector<Vec3>{z, z, z, y, y, y}));
}

TEST(Inventor, face_sets_and_strips) {
  const Scene concave = load_text(
      "FaceSet { vertexProperty VertexProperty { vertex [ 9 9 9, 0 0 0, 4 0 0, 1 1 0, 0 4 0 ] } startIndex 1 }");
  ASSERT_EQ(concave.triangles.size(), 2u);
  float area = 0.0f;
  for (const TriangleIndices& t : concave.triangles) {
    const Vec3 a = concave.positions[t.a];
    area += 0.5f * cross(concave.positions[t.b] - a, concave.positions[t.c] - a).z;
  }
  EXPECT_FLOAT_EQ(area, 4.0f);

  const std::string strip_points = "Coordinate3 { point [ 0 0 0, 1 0 0, 0 1 0, 1 1 0, 0 2 0 ] } ";
  for (const char* strip : {"TriangleStripSet { numVertices [ 5 ] }", "TriangleStripSet { }",
                            "IndexedTriangleStripSet { coordIndex [ 0, 1, 2, 3, 4, -1 ] }"}) {
    const Scene scene = load_text(strip_points + kColors + "MaterialBinding { value PER_FACE }" + strip);
    ASSERT_EQ(scene.triangles.size(), 3u);
    for (const TriangleIndices& t : scene.triangles) {
      const Vec3 a = scene.positions[t.a];
      EXPECT_FLOAT_EQ(cross(scene.positions[t.b] - a, scene.positions[t.c] - a).z, 1.0f);  // all wind one way
    }
    expect_near(diffuse_of(scene, 2), {0, 0, 1});
  }
}

TEST(Inventor, crease_angle) {
  const std::string roof =
      "Coordinate3 { point [ 0 0 0, 0 0 -1, 1 1 -1, 1 1 0, 2 0 0, 2 0 -1 ] } "
      "IndexedFaceSet { coordIndex [ 3 2 1 0 -1 3 4 5 2 -1 ] }";
  EXPECT_TRUE(load_text(roof).normals.empty());
  const Scene smooth = load_text("ShapeHints { creaseAngle 1.6 }" + roof);
  expect_near(smooth.normals[0], {0, 1, 0});
  expect_near(smooth.normals[3], {-std::sqrt(0.5f), std::sqrt(0.5f), 0});
  const Scene vrml = load_text("ShapeHints { }" + roof, "#VRML V1.0 ascii\n");
  expect_near(vrml.normals[0], {-std::sqrt(0.5f), std::sqrt(0.5f), 0});
}

TEST(Inventor, texture_coordinates) {
  const std::string texture = "Texture2 { image 1 1 1 0x80 } ";
  const Scene by_box = load_text(texture + "Coordinate3 { point [ 0 0 0, 0 2 0, 1 0 0 ] } FaceSet { }");
  EXPECT_EQ(by_box.textures[0].texels[0], 0x808080u);
  EXPECT_FLOAT_EQ(by_box.texcoords[1].s, 1.0f);
  EXPECT_FLOAT_EQ(by_box.texcoords[2].t, 0.5f);
  const Scene moved = load_text(texture + kSquare +
                                "Texture2Transform { translation 0.5 0 scaleFactor 2 2 } TextureCoordinate2 { point "
                                "[ 0 0, 1 0, 1 1, 0 1 ] } IndexedFaceSet { coordIndex [ 0 1 2 ] textureCoordIndex "
                                "[ 1 2 3 ] }");
  EXPECT_FLOAT_EQ(moved.texcoords[0].s, 2.5f);
  EXPECT_FLOAT_EQ(moved.texcoords[0].t, 1.0f);
  EXPECT_FLOAT_EQ(moved.texcoords[2].s, 0.5f);
  EXPECT_FLOAT_EQ(moved.texcoords[2].t, -1.0f);
  EXPECT_TRUE(load_text(kSquare + "TextureCoordinate2 { point [ 0 0 ] } FaceSet { }").texcoords.empty());
}

TEST(Inventor, packed_colors) {
  const Scene scene = load_text("PackedColor { orderedRGBA 0xff000080 } Cube { }");
  const float clear = 127.0f / 255.0f;
  expect_near(scene.materials[0].diffuse, {1 - clear, 0, 0});
  expect_near(scene.materials[0].transmission, {clear, clear, clear});
}

TEST(Inventor, what_is_skipped_is_told_once) {
  const Scene scene = load_text(
      "QuadMesh { }\nStrange { deep { [ 1 } ] DEF gone Cube { } }\nStrange { }\nUSE gone\nWWWInline { name \"x\" }\n"
      "Texture2 { filename \"../out.png\" }\nCube { }");
  EXPECT_EQ(scene.triangles.size(), 12u);
  ASSERT_EQ(scene.warnings.size(), 4u);
  EXPECT_NE(scene.warnings[0].find("line 2: nodes of type 'QuadMesh' are skipped"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("line 3: nodes of type 'Strange' are skipped"), std::string::npos);
  EXPECT_NE(scene.warnings[2].find("line 6: nodes of type 'WWWInline' are skipped"), std::string::npos);
  EXPECT_NE(scene.warnings[3].find("line 7: '../out.png' lies outside"), std::string::npos);
  EXPECT_EQ(scene.textures.size(), 1u);  // the checker
}

TEST(Inventor, originals) {
  const char* data = std::getenv("RAYWALK_SCENE_DATA");
  if (data == nullptr) GTEST_SKIP() << "RAYWALK_SCENE_DATA names no folder of original scene data";
  const std::filesystem::path folder = std::filesystem::path(data) / "iv";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "there is no iv in RAYWALK_SCENE_DATA";
  int loaded = 0, inventor = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path extension = entry.path().extension();
    if (extension != ".iv" && extension != ".wrl") continue;
    inventor += extension == ".iv";
    const Scene scene = load_mesh(entry.path());
    ++loaded;
    for (const Vec3 p : scene.positions) ASSERT_TRUE(is_finite(p)) << entry.path();
    EXPECT_LE(scene.triangles.size(), 10'000u) << entry.path();
  }
  EXPECT_EQ(inventor, 95);
  EXPECT_GE(loaded, inventor);
  EXPECT_EQ(load_mesh(folder / "oiv_compliance/indexedfaceset.iv").triangles.size(), 39u * 6u);
}

}  // namespace
}  // namespace raywalk::test
