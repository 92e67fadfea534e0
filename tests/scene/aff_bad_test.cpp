// AFF files that must be refused, each with a text that names the file and the line, in bounded time.
#include "tests/scene/aff_file.h"

namespace raywalk::test {
namespace {

struct Bad {
  const char* name;
  std::string content;
  std::vector<std::string> says;
};

void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

std::string times(int n, const std::string& text) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

std::vector<Bad> bad_files() {
  const std::string square = "m vertices 4\n0 0 0 1 0 0 1 1 0 0 1 0\n";
  const std::string key = "0 0 0 0 0 0 0\n";
  return {
      {"nothing", "# only a comment\n", {"no AFF statement"}},
      {"junk", "\x01\x02 \xff\xfe junk\n", {"no AFF statement"}},
      {"word_for_number", "l 1 2 zwei\n", {"line 1", "'zwei'", "not a number"}},
      {"number_and_letters", "\nl 1 2 3x\n", {"line 2", "'3x'"}},
      {"nan", "l 1 2 nan\n", {"line 1", "'nan' is not finite"}},
      {"infinite", "# c\r\n\r\np 3 0 0 0 1 0 0 -inf 1 0\n", {"line 3", "'-inf' is not finite"}},
      {"beyond_floats", "l 1 2 1e39\n", {"line 1", "'1e39' is not finite"}},
      {"beyond_doubles", "l 1 2 -1e400\n", {"line 1", "not finite"}},
      {"ends_early", "l 1 2\n", {"the file ends"}},
      {"long_word", "l " + std::string(5000, 'a'), {"line 1", "aaa..."}},
      {"polygon_count", "p 1000000\n0 0 0\n", {"line 1", "1000000 corners cannot fit"}},
      {"polygon_absurd", "p 99999999999999999999\n", {"line 1", "not an integer"}},
      {"polygon_negative", "p -3\n", {"line 1", "negative"}},
      {"polygon_fraction", "p 3.0\n", {"line 1", "'3.0' is not an integer"}},
      {"polygon_large", "p 2000\n" + times(2000, "0 0 0\n"), {"line 1", "2000 corners; the most is 1000"}},
      {"mesh_count", "m vertices 4000000000 0 0 0\n", {"line 1", "cannot fit"}},
      {"mesh_word", "m points 3\n", {"line 1", "'vertices' should be here, not 'points'"}},
      {"mesh_index", square + "triangles 1\n0 1 4\n", {"line 4", "vertex index 4 is out of range: there are 4"}},
      {"mesh_negative", square + "triangles 1\n0 -1 2\n", {"line 4", "vertex index -1"}},
      {"mesh_normal", square + "normals 1 0 0 1\ntriangles 1\n0 1 2  0 0 1\n", {"line 5", "normal index 1"}},
      {"mesh_texture",
       square + "texturecoords 1 a.ppm 0 0\ntriangles 1\n0 1 2  0 7 0\n",
       {"line 5", "texture coordinate index 7"}},
      {"mesh_too_many", square + "triangles 3\n0 1 2 0 2 3\n", {"line 3", "3 triangles cannot fit"}},
      {"mesh_without_points", "m vertices 0 triangles 1 0 0 0\n", {"line 1", "there are 0"}},
      {"keys_few", "k a {\n transl 3\n" + times(3, key) + "}\n", {"line 5", "at least 4 keys"}},
      {"keys_left", "k a {\n rot 4\n1" + times(4, " 0 0 0 1 0 0 0 0\n") + "}\n", {"line", "at least 4 keys"}},
      {"keys_count", "k a { scale 100\n" + times(4, key) + "}\n", {"line 1", "100 keys cannot fit"}},
      {"keys_word", "k a {\n fade 4\n}\n", {"line 2", "'fade'"}},
      {"keys_open", "k a {\n transl 4\n" + times(4, key), {"the file ends inside keyframes"}},
      {"visibility_value", "k a { visibility 1 0 2 }\n", {"line 1", "0 or 1"}},
      {"visibility_back", "k a { visibility 2 0 1 -1 0 }\n", {"line 1", "go back"}},
      {"moved_far", times(3, "xs 1e30 1 1 0 0 1 0 0 0 0 {") + "\nl 1 1 1", {"line 2", "beyond all floats"}},
      {"moved_far_by_keys",
       "k a { scale 4" + times(4, " 0 1e30 1 1 0 0 0") + " }\nx a { x a {\np 3 0 0 0 1 0 0 0 1 0 } }\n",
       {"line 2", "beyond all floats"}},
      {"tpa_none", "tpa 0\n", {"line 1", "without keys"}},
      {"tpa_count", "tpa 500 0 0 0\n", {"line 1", "cannot fit"}},
      {"tpa_back", "tpa 2\n0" + times(18, " 0") + "\n-1" + times(18, " 0"), {"line 3", "go back"}},
      {"brace_open", "xs 1 1 1 0 0 1 0 0 0 0 {\np 3 0 0 0 1 0 0 0 1 0\n", {"line 2", "ends inside braces"}},
      {"brace_close", "p 3 0 0 0 1 0 0 0 1 0 }\n", {"line 1", "no block"}},
      {"brace_missing", "x a p 3\n", {"line 1", "'{' should be here"}},
      {"brace_for_name", "x { }\n", {"line 1", "a brace where a name should be"}},
      {"group_open", "p 3 0 0 0 1 0 0 0 1 0\nunknown { {\n}\n", {"ends inside braces"}},
      {"deep", times(100'000, "xs 1 1 1 0 0 1 0 0 0 0 {"), {"line 1", "nested more than 256 deep"}},
      {"deep_animated", times(100'000, "x a\n{"), {"nested more than 256 deep"}},
      {"many_animated", times(100'001, "x a{}"), {"more than 100000 keyframed blocks"}},
      {"view_order", "v at 0 0 0\n", {"line 1", "'from' should be here"}},
      {"view_angle",
       "v from 0 0 1 at 0 0 0 up 0 1 0\nangle 180 hither 1 resolution 1 1\n",
       {"line 2", "between 0 and 180"}},
      {"animation_back", "a 5 1 100\n", {"line 1", "ends before it begins"}},
      {"animation_frames", "a 0 1 0\n", {"line 1", "without frames"}},
      {"include_missing", "\n\ni 0 not-there.aff\n", {"line 3", "no file 'not-there.aff'"}},
      {"include_outside", "i 0 ../other/file.aff\n", {"line 1", "outside the scene's folder"}},
      {"include_absolute", "i 0 /etc/hostname\n", {"line 1", "outside the scene's folder"}},
      {"include_itself", "i 0 test.aff\n", {"line 1", "includes itself"}},
      {"include_no_name", "i 0\n", {"line 1", "the file ends where a file should be"}},
  };
}

class AffBad : public testing::TestWithParam<Bad> {};

TEST_P(AffBad, is_refused) {
  const Folder folder;
  const auto file = folder.write("test.aff", GetParam().content);
  const std::string message = message_of([&] { load_mesh(file, aff_settings()); });
  EXPECT_NE(message.find("test.aff"), std::string::npos) << message;
  EXPECT_LT(message.size(), 400u);
  for (const std::string& part : GetParam().says) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' does not say '" << part << "'";
  }
}

INSTANTIATE_TEST_SUITE_P(Files, AffBad, testing::ValuesIn(bad_files()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(AffIncludes, cycles_are_refused) {
  const Folder folder;
  folder.write("sub/b.aff", "\ni 0 ../c.aff\n");
  folder.write("c.aff", "i 0 ./sub/../a.aff\n");
  const auto file = folder.write("a.aff", "i 0 sub/b.aff\n");
  const std::string message = message_of([&] { load_mesh(file); });
  EXPECT_NE(message.find("c.aff, line 1: './sub/../a.aff' includes itself"), std::string::npos) << message;
}

TEST(AffIncludes, an_error_names_the_included_file) {
  const Folder folder;
  folder.write("b.aff", "\np 3 0 0 0\n1 0 x 0 1 0\n");
  const std::string message = message_of([&] { load_mesh(folder.write("a.aff", "i 0 b.aff\n")); });
  EXPECT_NE(message.find("b.aff, line 3: 'x'"), std::string::npos) << message;
}

TEST(AffIncludes, a_block_ends_in_the_file_where_it_begins) {
  const Folder folder;
  folder.write("b.aff", "}\n");
  const std::string message = message_of([&] { load_mesh(folder.write("a.aff", "x a {\ni 0 b.aff\n")); });
  EXPECT_NE(message.find("b.aff, line 1: there is no block"), std::string::npos) << message;
}

TEST(AffIncludes, a_file_outside_through_the_root_is_allowed_inside_it) {
  const Folder folder;
  folder.write("parts/b.aff", "p 3 0 0 0 1 0 0 0 1 0\n");
  const auto file = folder.write("aff/a.aff", "i 0 ../parts/b.aff\n");
  EXPECT_EQ(load_mesh(file, aff_settings(folder.path())).triangles.size(), 1u);
  EXPECT_NE(message_of([&] { load_mesh(file); }).find("outside"), std::string::npos);
}

TEST(AffIncludes, a_link_does_not_lead_out_of_the_root) {
  const Folder folder;
  folder.write("outside.aff", "p 3 0 0 0 1 0 0 0 1 0\n");
  folder.write("root/deep/er/x.aff", "");
  std::filesystem::create_directory_symlink(folder.path() / "root/deep/er", folder.path() / "root/link");
  std::filesystem::create_symlink(folder.path() / "outside.aff", folder.path() / "root/b.aff");
  for (const char* name : {"link/../../outside.aff", "b.aff"}) {
    const auto file = folder.write("root/a.aff", std::string("i 0 ") + name + "\n");
    EXPECT_NE(message_of([&] { load_mesh(file); }).find("lies outside"), std::string::npos) << name;
  }
}

TEST(AffIncludes, a_missing_texture_is_told_as_missing) {
  const Folder folder;
  const Scene scene = load_mesh(folder.write("a.aff", "tt no.ppm 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1\n"), aff_settings());
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("a.aff, line 1: there is no texture 'no.ppm'"), std::string::npos)
      << scene.warnings[0];
}

/// "f<n>.aff".
std::string file_name(int number) {
  return std::string("f").append(std::to_string(number)).append(".aff");
}

TEST(AffIncludes, doubling_chains_end) {
  const Folder folder;
  constexpr int kFiles = 40;
  for (int i = 0; i < kFiles; ++i) {
    const std::string next = "i 0 " + file_name(i + 1) + "\n";
    folder.write(file_name(i), next + next);
  }
  folder.write(file_name(kFiles), "l 0 0 0\n");
  const std::string message = message_of([&] { load_mesh(folder.path() / "f0.aff"); });
  EXPECT_NE(message.find("more than 20000 files are included"), std::string::npos) << message;
}

TEST(AffIncludes, long_chains_end) {
  const Folder folder;
  for (int i = 0; i < 70; ++i) {
    folder.write(file_name(i), "i 0 " + file_name(i + 1) + "\n");
  }
  const std::string message = message_of([&] { load_mesh(folder.path() / "f0.aff"); });
  EXPECT_NE(message.find("more than 64 deep"), std::string::npos) << message;
}

TEST(AffIncludes, what_is_read_and_made_is_limited) {
  const Folder folder;
  folder.write("b.aff", "s 0 0 0 1\n" + std::string(1000, ' '));
  std::string content;
  for (int i = 0; i < 100; ++i) content += "i 0 b.aff\n";
  const auto file = folder.write("a.aff", content);
  ImportSettings few_bytes = aff_settings(), few_triangles = aff_settings();
  few_bytes.limits.bytes = 20'000;
  EXPECT_NE(message_of([&] { load_mesh(file, few_bytes); }).find("hold too much"), std::string::npos);
  few_triangles.limits.triangles = 2000;
  const std::string message = message_of([&] { load_mesh(file, few_triangles); });
  EXPECT_NE(message.find("b.aff, line 1: more than 2000 triangles"), std::string::npos) << message;
}

}  // namespace
}  // namespace raywalk::test
