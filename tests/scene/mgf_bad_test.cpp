// MGF that is wrong: an error that names file and line, soon and without eating memory.
#include <gtest/gtest.h>

#include "tests/scene/mgf_file.h"

namespace raywalk::test {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(MgfBad, each_error_names_file_line_and_cause) {
  const struct {
    const char* statement;
    const char* cause;
  } cases[] = {
      {"f a b nobody", "vertex 'nobody' is not defined"},
      {"v e = nobody", "vertex 'nobody' is not defined"},
      {"v e is a", "'=' is missing"},
      {"m nothing", "material 'nothing' is not defined"},
      {"m x = nothing", "material 'nothing' is not defined"},
      {"c nothing", "colour 'nothing' is not defined"},
      {"cmix 1 nothing", "colour 'nothing' is not defined"},
      {"cmix 1 nothing 2", "pairs"},
      {"cxy 0.3", "'cxy' takes 2 arguments, not 1"},
      {"cxy 0.3 0", "no colour"},
      {"cxy 0.7 0.7", "no colour"},
      {"cxy -0.1 0.5", "no colour"},
      {"cxy 0.5 1e-300", "so little luminance"},
      {"cspec 380 780 0 0", "without light"},
      {"cspec 780 380 1 1", "wavelengths"},
      {"cspec 380 780 1", "'cspec' takes 4 or more arguments, not 3"},
      {"cct 0", "temperature"},
      {"rd x", "'x' is not a number"},
      {"rd -0.1", "negative"},
      {"ed 1e300", "more light than a float can tell"},
      {"rd 0.5 0.5", "'rd' takes 1 arguments, not 2"},
      {"rs 0.5", "'rs' takes 2 arguments, not 1"},
      {"ir 1.5", "'ir' takes 2 arguments, not 1"},
      {"sides 3", "1 or 2 sides"},
      {"sides two", "whole number"},
      {"p 1 2", "'p' takes 3 arguments, not 2"},
      {"p 1 nan 2", "'nan' is not finite"},
      {"n 1 inf 2", "'inf' is not finite"},
      {"p 1 1e999 2", "'1e999'"},
      {"v a b c d", "'v' takes 0 to 3 arguments, not 4"},
      {"f a b", "'f' takes 3 or more arguments, not 2"},
      {"sph a 0", "radius of zero"},
      {"sph a", "'sph' takes 2 arguments, not 1"},
      {"cyl a 0 b", "radius of zero"},
      {"cyl a 1 a", "one point"},
      {"cone a 1 b -1", "different signs"},
      {"ring a 0 1", "no normal"},
      {"torus a 1 2", "no normal"},
      {"ring up 2 1", "inner radius"},
      {"torus up -1 2", "different signs"},
      {"prism a b c", "'prism' takes 4 or more arguments, not 3"},
      {"prism a b c d", "'d' is not a number"},
      {"prism a b c 0", "no length"},
      {"prism a a b 1", "no area"},
      {"xf", "closes none"},
      {"xf -t 0 0", "'-t' takes 3 numbers"},
      {"xf -rx", "'-rx' takes 1 numbers"},
      {"xf -rx ninety", "'ninety' is not a number"},
      {"xf -q 1", "'-q' is no transformation"},
      {"xf -s 0", "scale of zero"},
      {"xf -s 1e20 -s 1e20", "infinity"},
      {"xf -i 1000000000000 -s 1.1", "infinity"},
      {"xf -a 0", "whole number"},
      {"xf -a 1.5", "whole number"},
      {"xf -i -1", "whole number"},
      {"xf -t 1 0 0", "not closed"},
      {"i missing.mgf", "there is no file 'missing.mgf'"},
      {"i a.mgf", "includes itself"},
      {"i ../a.mgf", "outside"},
      {"i /etc/passwd", "outside"},
  };
  for (const auto& one : cases) {
    const std::string error = mgf_error(kMgfSquare + "v up = a\nn 0 0 1\n" + one.statement + "\n");
    EXPECT_NE(error.find("a.mgf, line 11: "), std::string::npos) << one.statement << ": " << error;
    EXPECT_NE(error.find(one.cause), std::string::npos) << one.statement << ": " << error;
  }
}

TEST(MgfBad, an_error_in_an_include_names_the_include) {
  const Folder folder;
  folder.write("parts/b.mgf", "# one\nrd much\n");
  const std::string error = message_of([&] { load_mesh(folder.write("a.mgf", "o x\ni parts/b.mgf\n")); });
  EXPECT_NE(error.find("b.mgf, line 2: 'much' is not a number"), std::string::npos) << error;
  folder.write("parts/b.mgf", "xf\n");
  const std::string other = message_of([&] { load_mesh(folder.write("a.mgf", "xf -mx\ni parts/b.mgf\nxf\n")); });
  EXPECT_NE(other.find("b.mgf, line 1: this 'xf' closes none"), std::string::npos) << other;
}

TEST(MgfBad, circles_of_includes) {
  const Folder folder;
  folder.write("b.mgf", "i c.mgf\n");
  folder.write("c.mgf", "\ni ./b.mgf\n");
  const std::string error = message_of([&] { load_mesh(folder.write("a.mgf", "i b.mgf\n")); });
  EXPECT_NE(error.find("c.mgf, line 2: './b.mgf' includes itself"), std::string::npos) << error;
}

TEST(MgfBad, includes_that_double_and_double) {
  const Folder folder;
  const auto name = [](int i) { return std::to_string(i).append(".mgf"); };
  const auto include = [&](int i) { return std::string("i ").append(name(i)).append("\n"); };
  for (int i = 0; i < 40; ++i) folder.write(name(i), include(i + 1) + include(i + 1));
  folder.write(name(40), "rd 0.5\n");
  const std::string error = message_of([&] { load_mesh(folder.path() / name(0)); });
  EXPECT_NE(error.find("repeat too much"), std::string::npos) << error;
  for (int i = 100; i < 170; ++i) folder.write(name(i), include(i + 1));
  const std::string deep = message_of([&] { load_mesh(folder.path() / name(100)); });
  EXPECT_NE(deep.find("more than 64 deep"), std::string::npos) << deep;
}

TEST(MgfBad, absurd_arrays) {
  const std::string huge = "xf -a 1000000000 -t 1 0 0 -a 1000000000 -t 0 1 0\n";
  EXPECT_NE(mgf_error(huge + huge + "xf\nxf\n").find("repeat too much"), std::string::npos);
  const Folder folder;
  folder.write("empty.mgf", "");
  EXPECT_NE(
      message_of([&] { load_mesh(folder.write("a.mgf", "i empty.mgf -a 1000000000\n")); }).find("repeat too much"),
      std::string::npos);
  ImportSettings settings;
  settings.limits.triangles = 100'000;
  const std::string error = message_of([&] { mgf_scene(kMgfSquare + huge + "f a b c d\nxf\n", settings); });
  EXPECT_NE(error.find("a.mgf, line 10: more than 100000 triangles"), std::string::npos) << error;
}

TEST(MgfBad, deep_nesting) {
  EXPECT_NE(mgf_error(repeated("xf -t 1 0 0\n", 1001)).find("line 1001: transformations are nested"),
            std::string::npos);
  EXPECT_NE(mgf_error(repeated("o x\n", 1001)).find("line 1001: objects are nested"), std::string::npos);
  EXPECT_EQ(mgf_error(repeated("xf -t 1 0 0\no x\n", 1000) + repeated("o\nxf\n", 1000)), "");
}

TEST(MgfBad, coordinates_beyond_floats) {
  const std::string error = mgf_error(kMgfSquare + "v e =\np 1e39 0 0\nf a b e\n");
  EXPECT_NE(error.find("a.mgf, line 11: a coordinate beyond all floats"), std::string::npos) << error;
}

TEST(MgfBad, statements_and_polygons_without_end) {
  EXPECT_NE(mgf_error("f " + repeated("a ", 10'001)).find("line 1: a statement of more than 10000 words"),
            std::string::npos);
  EXPECT_NE(mgf_error(kMgfSquare + "f " + repeated("a b c d ", 300)).find("line 9: a polygon of 1200 corners"),
            std::string::npos);
}

TEST(MgfBad, noise_does_no_harm) {
  u32 state = 1;
  const char* words[] = {"xf", "-a", "2", "-t", "1", "o",  "v", "a",  "=",
                         "p",  "0",  "f", "b",  "m", "rd", "c", "\n", "\\\n"};
  for (int round = 0; round < 300; ++round) {
    std::string text = kMgfSquare;
    for (int i = 0; i < 60; ++i) {
      state = state * 1664525u + 1013904223u;
      text += words[(state >> 16) % std::size(words)];
      text += (state >> 28) < 5 ? "\n" : " ";
    }
    mgf_error(text);
  }
}

}  // namespace
}  // namespace raywalk::test
