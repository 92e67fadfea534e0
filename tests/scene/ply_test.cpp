// PLY files that must be read: every encoding, order, type, polygon.
#include <gtest/gtest.h>
#include <zlib.h>

#include <clocale>
#include <cmath>

#include "server/scene/importer.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

constexpr Vec3 kSquare[4] = {{0, 0, 0.5f}, {2, 0, 0.5f}, {2, 1, 0.5f}, {0, 1, 0.5f}};

/// Twice the area, by the sum of the triangles' cross products; signed along +z.
float signed_area(const Scene& scene) {
  float area = 0.0f;
  for (const TriangleIndices& t : scene.triangles) {
    const Vec3 a = scene.positions[t.a];
    area += cross(scene.positions[t.b] - a, scene.positions[t.c] - a).z;
  }
  return area;
}

void expect_square(const Scene& scene) {
  ASSERT_EQ(scene.positions.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(scene.positions[i], kSquare[i]);
  ASSERT_EQ(scene.triangles.size(), 2u);
  EXPECT_FLOAT_EQ(signed_area(scene), 4.0f);
}

template <class Index, class Count>
std::string binary_square(bool big_endian, const std::string& index_type, const std::string& count_type) {
  std::string header =
      "ply\nformat " + std::string(big_endian ? "binary_big_endian" : "binary_little_endian") + " 1.0\n";
  // Odd order, values that are not wanted, a list before the coordinates, faces with a value behind the list.
  header +=
      "element vertex 4\nproperty list uchar short junk\nproperty double z\nproperty uchar red\nproperty float x\n"
      "property float y\nelement face 1\nproperty list " +
      count_type + " " + index_type + " vertex_index\nproperty int flags\nend_header\n";
  Bytes bytes(big_endian);
  for (const Vec3& p : kSquare) {
    bytes.add<u8>(2).add<short>(-1).add<short>(7).add<double>(p.z).add<u8>(255).add<float>(p.x).add<float>(p.y);
  }
  bytes.add<Count>(4);
  for (int i = 0; i < 4; ++i) bytes.add<Index>(static_cast<Index>(i));
  bytes.add<i32>(99);
  return header + bytes.text();
}

TEST(Ply, text) {
  const Folder folder;
  const auto file = folder.write("a.ply",
                                 "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info x\r\nelement vertex 4\r\n"
                                 "property float x\r\nproperty float y\r\nproperty float z\r\nelement face 1\r\n"
                                 "property list uchar int vertex_indices\r\nend_header\r\n"
                                 "0 0 0.5\r\n 2.0  0 5e-1 \r\n\r\n+2 1 .5\r\n-0 1 0.5\r\n4 0 1 2 3");
  const Scene scene = load_mesh(file);
  expect_square(scene);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.name, "a");
  EXPECT_EQ(scene.content_sha256.size(), 64u);
  EXPECT_FALSE(scene.lights.empty());
  EXPECT_FALSE(scene.materials.empty());
}

TEST(Ply, binary_of_both_byte_orders_and_all_index_types) {
  const Folder folder;
  int n = 0;
  const auto check = [&](const std::string& content) {
    expect_square(load_mesh(folder.write(std::to_string(n++).append(".ply"), content)));
  };
  for (const bool big : {false, true}) {
    check(binary_square<signed char, u8>(big, "char", "uchar"));
    check(binary_square<u8, signed char>(big, "uint8", "int8"));
    check(binary_square<short, unsigned short>(big, "int16", "ushort"));
    check(binary_square<unsigned short, short>(big, "uint16", "short"));
    check(binary_square<i32, u32>(big, "int", "uint"));
    check(binary_square<u32, i32>(big, "uint32", "int32"));
  }
}

TEST(Ply, gzip_is_found_by_content) {
  const Folder folder;
  const std::string content = binary_square<i32, u8>(false, "int", "uchar");
  const auto file = folder.path() / "square.bin";
  gzFile gz = gzopen(file.c_str(), "wb");
  gzwrite(gz, content.data(), static_cast<unsigned>(content.size()));
  gzclose(gz);
  expect_square(load_mesh(file));
}

TEST(Ply, faces_before_vertices_normals_and_materials) {
  const Folder folder;
  const Scene scene = load_mesh(folder.write(
      "c.ply",
      "ply\nformat ascii 1.0\nelement junk 2\nproperty int a\nelement face 2\nproperty uchar material_index\n"
      "property list uchar uint vertex_indices\nelement vertex 4\nproperty float nx\nproperty float ny\n"
      "property float nz\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "1\n2\n2 4 0 1 2 3\n1 3 0 1 2\n0 0 1 0 0 0.5\n0 0 1 2 0 0.5\n0 0 1 2 1 0.5\n0 0 1 0 1 0.5\n"));
  ASSERT_EQ(scene.triangles.size(), 3u);
  EXPECT_FLOAT_EQ(signed_area(scene), 6.0f);
  EXPECT_EQ(scene.triangles[0].material, 2u);
  EXPECT_EQ(scene.triangles[1].material, 2u);
  EXPECT_EQ(scene.triangles[2].material, 1u);
  EXPECT_EQ(scene.materials.size(), 3u);
  ASSERT_EQ(scene.normals.size(), 4u);
  EXPECT_EQ(scene.normals[3], (Vec3{0, 0, 1}));
}

TEST(Ply, concave_polygons_keep_their_area_and_winding) {
  // A comb with two teeth, once in the xy plane and once turned round.
  const std::string corners = "0 0 0\n5 0 0\n5 3 0\n4 3 0\n4 1 0\n3 1 0\n3 3 0\n2 3 0\n2 1 0\n1 1 0\n1 3 0\n0 3 0\n";
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const Folder folder;
  const Scene comb = load_mesh(folder.write("d.ply", header + corners + "12 0 1 2 3 4 5 6 7 8 9 10 11\n"));
  ASSERT_EQ(comb.triangles.size(), 10u);
  EXPECT_FLOAT_EQ(signed_area(comb), 2.0f * (5.0f + 6.0f));
  for (const TriangleIndices& t : comb.triangles) {
    const Vec3 a = comb.positions[t.a];
    EXPECT_GT(cross(comb.positions[t.b] - a, comb.positions[t.c] - a).z, 0.0f);
  }
  const Scene turned = load_mesh(folder.write("e.ply", header + corners + "12 11 10 9 8 7 6 5 4 3 2 1 0\n"));
  EXPECT_FLOAT_EQ(signed_area(turned), -2.0f * (5.0f + 6.0f));
}

TEST(Ply, odd_values_are_accepted_with_a_warning) {
  const Folder folder;
  const Scene scene = load_mesh(folder.write(
      "f.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 3\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 nan\n1e60 1e-60 -inf\n0 1 0\n3 0 1 2\n2 0 1\n3 0 "
      "3 0\n"));
  EXPECT_TRUE(std::isnan(scene.positions[1].z));
  EXPECT_TRUE(std::isinf(scene.positions[2].x));
  EXPECT_EQ(scene.positions[2].y, 0.0f);
  EXPECT_EQ(scene.triangles.size(), 2u);
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_NE(scene.warnings[0].find("2 vertices are not finite"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("1 faces with fewer than three corners"), std::string::npos);
}

TEST(Ply, empty_mesh_is_a_scene) {
  const Folder folder;
  const Scene scene = load_mesh(folder.write(
      "g.ply",
      "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n"));
  EXPECT_TRUE(scene.triangles.empty());
  EXPECT_EQ(scene.warnings.size(), 1u);
  const Blob blob = pack(scene);
  EXPECT_TRUE(blob.header<SceneHeader>().bounds.empty());
}

TEST(Ply, numbers_do_not_depend_on_the_locale) {
  const char* old = std::setlocale(LC_NUMERIC, nullptr);
  const std::string keep = old;
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_NUMERIC, name) == nullptr) continue;
    const Folder folder;
    const Scene scene = load_mesh(folder.write("h.ply",
                                               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                                               "float y\nproperty float z\nend_header\n0.5 1.25 -3.75\n"));
    EXPECT_EQ(scene.positions[0], (Vec3{0.5f, 1.25f, -3.75f}));
  }
  std::setlocale(LC_NUMERIC, keep.c_str());
}

}  // namespace
}  // namespace raywalk::test
