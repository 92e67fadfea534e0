// PLY files that must be refused, each with a text that names the file and the place.
#include <gtest/gtest.h>
#include <zlib.h>

#include "server/scene/importer.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_indices\n";
const std::string kText = "ply\nformat ascii 1.0\n";
const std::string kBinary = "ply\nformat binary_little_endian 1.0\n";

struct Bad {
  const char* name;
  std::string content;
  std::vector<std::string> says;
};

void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

std::vector<Bad> bad_files() {
  const std::string triangle = kText + "element vertex 3\n" + kXyz + "element face 1\n" + kFaces + "end_header\n";
  const std::string binary_head = kBinary + "element vertex 1\n" + kXyz + "element face 1\n" + kFaces + "end_header\n";
  const std::string vertex = Bytes(false).add(0.0f).add(0.0f).add(0.0f).text();
  const std::string at = "byte " + std::to_string(binary_head.size());
  return {
      {"unknown_format", "ply\nformat ebcdic 1.0\nend_header\n", {"line 2", "ebcdic"}},
      {"version", "ply\nformat ascii 2.0\nend_header\n", {"line 2", "2.0"}},
      {"no_format", "ply\nend_header\n", {"line 2", "format"}},
      {"no_end", kText + "element vertex 3\n", {"line 3", "end_header"}},
      {"unknown_keyword", kText + "elephant\nend_header\n", {"line 3", "elephant"}},
      {"unknown_type", kText + "element vertex 1\nproperty quaternion x\nend_header\n", {"line 4", "quaternion"}},
      {"float_count",
       kText + "element face 1\nproperty list float int vertex_indices\nend_header\n",
       {"line 4", "length"}},
      {"negative_count", kText + "element vertex -3\nend_header\n", {"line 3", "-3"}},
      {"property_first", kText + "property float x\nend_header\n", {"line 3", "before any element"}},
      {"twice", kText + "element vertex 1\nproperty float x\nproperty float x\nend_header\n", {"line 5", "second"}},
      {"no_vertices", kText + "element face 0\n" + kFaces + "end_header\n", {"line 5", "vertex"}},
      {"no_z", kText + "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n", {"line 6", "'z'"}},
      {"lying_count",
       kText + "element vertex 4000000000\n" + kXyz + "end_header\n0 0 0\n",
       {"line 7", "4000000000", "cannot fit"}},
      {"lying_binary", kBinary + "element vertex 2\n" + kXyz + "end_header\n" + vertex, {"line 7", "cannot fit"}},
      {"truncated_text", triangle + "0 0 0\n1 0 0 00000000\n", {"line 11", "vertex 1 has more values"}},
      {"too_few_values", triangle + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", {"line 11", "vertex 1 has fewer values"}},
      {"ends_early",
       triangle + "0 0 0.0000000\n1 0 0.0000000\n",
       {"the file ends after 2 of 3 rows of element vertex"}},
      {"no_number", triangle + "0 0 0\n1 zwei 0\n0 1 0\n3 0 1 2\n", {"line 11", "'zwei'"}},
      {"index_text", triangle + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", {"line 13", "vertex index 3 is out of range"}},
      {"index_negative", triangle + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", {"line 13", "vertex index -1"}},
      {"index_fraction", triangle + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", {"line 13", "'1.5' is not an integer"}},
      {"list_negative", triangle + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", {"line 13", "length -3"}},
      {"truncated_binary",
       binary_head + vertex + Bytes(false).add<u8>(3).add<i32>(0).text(),
       {"ends within element face", "byte"}},
      {"index_binary",
       binary_head + vertex + Bytes(false).add<u8>(3).add<i32>(0).add<i32>(0).add<i32>(70).text(),
       {"vertex index 70", "byte " + std::to_string(binary_head.size() + 12 + 13)}},
      {"material",
       kText + "element vertex 1\n" + kXyz + "element face 1\nproperty int material_index\n" + kFaces +
           "end_header\n0 0 0\n-1 3 0 0 0\n",
       {"line 12", "material index -1"}},
      {"list_x",
       kText + "element vertex 1\nproperty list uchar int x\nproperty float y\nproperty float z\nend_header\n1 1 1 1\n",
       {"'x'", "list"}},
      {"no_indices",
       kText + "element vertex 1\n" + kXyz + "element face 1\nproperty int a\nend_header\n0 0 0\n1\n",
       {"vertex_indices"}},
      {"not_a_mesh", "hello\n", {"line 1", "begins with"}},
  };
}

class BadPly : public testing::TestWithParam<Bad> {};

TEST_P(BadPly, is_refused) {
  const Folder folder;
  const auto file = folder.write(std::string(GetParam().name) + ".ply", GetParam().content);
  const std::string message = message_of([&] { load_mesh(file); });
  EXPECT_NE(message.find(file.string()), std::string::npos) << message;
  for (const std::string& part : GetParam().says) EXPECT_NE(message.find(part), std::string::npos) << message;
}
INSTANTIATE_TEST_SUITE_P(, BadPly, testing::ValuesIn(bad_files()), [](const auto& each) { return each.param.name; });

TEST(BadMesh, other_files) {
  const Folder folder;
  EXPECT_NE(message_of([&] { load_mesh(folder.path() / "none.ply"); }).find("no such file"), std::string::npos);
  EXPECT_NE(message_of([&] { load_mesh(folder.path()); }).find("not a regular file"), std::string::npos);
  const auto text = folder.write("a.txt", "hello");
  EXPECT_EQ(message_of([&] { load_mesh(text); }),
            text.string() + ": not a known scene format (known: AFF, glTF, Open Inventor, MGF, OBJ, PLY)");
  const auto empty = folder.write("empty.ply", "");
  EXPECT_NE(message_of([&] { load_mesh(empty); }).find("empty.ply"), std::string::npos);
}

TEST(BadMesh, damaged_gzip) {
  const Folder folder;
  std::string content = kText + "element vertex 20000\n" + kXyz + "end_header\n";
  for (int i = 0; i < 20000; ++i) content += std::to_string(i * 7919 % 10007) + " 1 " + std::to_string(i) + "\n";
  const auto file = folder.path() / "a.ply.gz";
  gzFile gz = gzopen(file.c_str(), "wb");
  gzwrite(gz, content.data(), static_cast<unsigned>(content.size()));
  gzclose(gz);
  EXPECT_EQ(load_mesh(file).positions.size(), 20000u);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const std::string message = message_of([&] { load_mesh(file); });
  EXPECT_NE(message.find("a.ply.gz, byte"), std::string::npos) << message;
  EXPECT_NE(message.find("gzip"), std::string::npos) << message;
}

}  // namespace
}  // namespace raywalk::test
