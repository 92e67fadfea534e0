// Open Inventor files that must be refused, each with a text that names the file and the line, in little time.
#include <gtest/gtest.h>

#include "server/scene/importer.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

struct Bad {
  const char* name;
  std::string content;
  std::string says;
};
void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

const std::string kHead = "#Inventor V2.1 ascii\n";
const std::string kThree = "Coordinate3 { point [ 0 0 0, 1 0 0, 0 1 0 ] }\n";

/// Each name stands for twice what the name before stands for.
std::string doubling(int levels, const std::string& core) {
  std::string text = kHead + "DEF n0 Group { " + core + " }\n";
  for (int i = 1; i <= levels; ++i) {
    const std::string use = " USE n" + std::to_string(i - 1);
    text += "DEF n" + std::to_string(i) + " Group {" + use + use + " }\n";
  }
  return text;
}

std::string chain(int levels) {
  std::string text = kHead + "DEF n0 Group { }\n";
  for (int i = 1; i <= levels; ++i) {
    text += "DEF n" + std::to_string(i) + " Group { USE n" + std::to_string(i - 1) + " }\n";
  }
  return text;
}

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

std::vector<Bad> bad_files() {
  return {
      {"vrml_2", "#VRML V2.0 utf8\nShape { }\n", "line 1: VRML 2.0 is not supported"},
      {"binary", "#Inventor V2.1 binary\n", "line 1: binary Open Inventor is not supported"},
      {"version", "#Inventor V9.0 ascii\n", "line 1: the first line is neither"},
      {"zero_byte", kHead + std::string("Cube {\0}", 8), "line 1: a zero byte"},
      {"open", kHead + "Separator {\nCube {\n", "line 3: the '{' of 'Cube' is never closed"},
      {"open_unknown", kHead + "\nStrange { {", "line 3: the '{' of 'Strange' is never closed"},
      {"open_list", kHead + "Normal {\nvector [ 0 0 1", "line 3: the list of 'vector' is never closed"},
      {"closed", kHead + "Cube { } }", "line 2: a node was expected, not '}'"},
      {"no_brace", kHead + "Cube Cone", "line 2: '{' was expected after 'Cube'"},
      {"no_field", kHead + "Cube { ] }", "line 2: a field or node of 'Cube' was expected, not ']'"},
      {"no_value", kHead + "Cube { width }", "line 2: a value of 'width' was expected"},
      {"undefined", kHead + "Cube { }\nUSE nobody", "line 3: USE of 'nobody', which is not defined before"},
      {"of_itself", kHead + "DEF a Separator {\nUSE a }", "line 3: USE of 'a', which is not defined before"},
      {"nan", kHead + "Cube {\nwidth nan }", "line 3: 'nan' is not a finite number"},
      {"infinite", kHead + "Cube { width -inf }", "line 2: '-inf' is not a finite number"},
      {"beyond", kHead + "Normal { vector [ 0 0\n1e400 ] }", "line 3: '1e400' is not a finite number"},
      {"beyond_float", kHead + "Cube { width 1e40 }", "line 2: '1e40' is not a finite number"},
      {"overflow", kHead + repeated("Scale { scaleFactor 1e30 1 1 }\n", 3) + "Cube { }",
       "line 5: transformed, a vertex is not finite"},
      {"word", kHead + "Cube { width wide }", "line 2: Cube.width: 'wide' is not a number"},
      {"arity", kHead + "Coordinate3 { point [ 1 2 3 4 ] }", "Coordinate3.point: 4 numbers are not a multiple of 3"},
      {"many", kHead + "Translation { translation 1 2 }", "Translation.translation: 2 numbers where 3 were expected"},
      {"high", kHead + kThree + "IndexedFaceSet {\ncoordIndex [ 0 1 3 ] }",
       "line 4: IndexedFaceSet.coordIndex: index 3 is out of range: there are 3 points"},
      {"negative", kHead + kThree + "IndexedFaceSet { coordIndex [ 0 1 -2 ] }", "index -2 is out of range"},
      {"fraction", kHead + kThree + "IndexedFaceSet { coordIndex [ 0 1 0.5 ] }", "index 0.5 is out of range"},
      {"no_points", kHead + "IndexedFaceSet { coordIndex [ 0 0 0 ] }", "index 0 is out of range: there are 0 points"},
      {"material",
       kHead + kThree +
           "MaterialBinding { value PER_FACE_INDEXED }\nIndexedFaceSet { coordIndex [ 0 1 2 ] "
           "materialIndex [ 1 ] }",
       "line 4: IndexedFaceSet.materialIndex: index 1 is out of range: there are 1"},
      {"normal",
       kHead + kThree + "Normal { vector 0 0 1 }\nIndexedFaceSet { coordIndex [ 0 1 2 ] normalIndex [ 0 0 1 ] }",
       "line 4: IndexedFaceSet.normalIndex: index 1 is out of range"},
      {"few", kHead + kThree + "Normal { vector 0 0 1 }\nIndexedFaceSet { coordIndex [ 0 1 2 ] normalIndex [ 0 0 ] }",
       "line 4: IndexedFaceSet.normalIndex: there are too few indices"},
      {"count", kHead + kThree + "FaceSet { numVertices [ 2000000000 ] }",
       "FaceSet.numVertices: index out of range: there are 3 points"},
      {"count_negative", kHead + kThree + "FaceSet { numVertices -7 }", "FaceSet.numVertices: a count was expected"},
      {"start", kHead + kThree + "FaceSet { startIndex 9 numVertices 1 }", "index out of range"},
      {"binding", kHead + "MaterialBinding { value PER_MOON }", "unknown binding 'PER_MOON'"},
      {"choice", kHead + "Switch {\nwhichChild 5 Cube { } }", "line 3: Switch.whichChild: there is no child 5"},
      {"projection", kHead + "MatrixTransform { matrix 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1 }", "projective"},
      {"image", kHead + "Texture2 {\nimage 60000 60000 3 0xff }",
       "line 3: Texture2.image: 1 texels where 60000 x 60000 were expected"},
      {"image_size", kHead + "Texture2 { image -1 1 3 0xff }", "width, height and a number of components"},
      {"packed", kHead + "PackedColor { orderedRGBA -1 }", "a colour that has no 32 bits"},
      {"property", kHead + "FaceSet { vertexProperty Cube { } }", "a VertexProperty was expected"},
      {"missing", kHead + "\nFile { name \"none.iv\" }", "line 3: File.name: there is no file 'none.iv'"},
      {"outside", kHead + "File { name \"../a.iv\" }", "line 2: '../a.iv' lies outside"},
      {"itself", kHead + "File { name \"bad.iv\" }", "line 2: File.name: 'bad.iv' includes itself"},
      {"cycle", kHead + "File { name \"other.iv\" }", "other.iv, line 3: File.name: 'bad.iv' includes itself"},
      {"no_inventor", kHead + "File { name \"text.iv\" }", "text.iv, line 1: the first line is neither"},
      {"many_fields", kHead + "Cube {\n" + repeated("width 1\n", 65) + "}", "line 67: 'Cube' has more than 64 fields"},
      {"braces", kHead + repeated("Group {\n", 100'000), "line 202: nodes are nested more than 200 deep"},
      {"fields", kHead + repeated("FaceSet { vertexProperty\n", 100'000), "nodes are nested more than 200 deep"},
      {"exponential", doubling(60, "Info { }"), "USE makes more than two million nodes of the file's"},
      {"exponential_indices", doubling(60, kThree + "IndexedFaceSet { coordIndex [ " + repeated("-1 ", 1000) + "] }"),
       "USE makes more than"},
      {"deep_use", chain(100'000), "nodes more than 400 deep, by USE"},
      {"corners", kHead + "Coordinate3 { point [ " + repeated("0 0 0 ", 1001) + "] }\nFaceSet { }",
       "line 3: a polygon of 1001 corners; the most is 1000"},
  };
}

class BadInventor : public testing::TestWithParam<Bad> {};

TEST_P(BadInventor, is_refused) {
  const Folder folder;
  folder.write("other.iv", kHead + "\nFile { name \"bad.iv\" }");
  folder.write("text.iv", "hello\n");
  const auto file = folder.write("bad.iv", GetParam().content);
  const std::string message = message_of([&] { load_mesh(file); });
  EXPECT_NE(message.find(folder.path().string()), std::string::npos) << message;
  EXPECT_NE(message.find(GetParam().says), std::string::npos) << message;
}
INSTANTIATE_TEST_SUITE_P(, BadInventor, testing::ValuesIn(bad_files()),
                         [](const auto& each) { return each.param.name; });

TEST(InventorLimits, too_many_triangles) {
  const Folder folder;
  const auto file = folder.write("a.iv", doubling(40, "Cube { }"));
  const std::string message = message_of([&] { load_mesh(file, {.limits = {.triangles = 1000}}); });
  EXPECT_NE(message.find("line 2: more than 1000 triangles"), std::string::npos) << message;
}

TEST(InventorLimits, many_unknown_braces_take_no_stack) {
  const Folder folder;
  const auto file = folder.write("a.iv", kHead + repeated("Strange {", 1'000'000) + repeated("}", 1'000'000));
  EXPECT_EQ(load_mesh(file).triangles.size(), 0u);
}

TEST(InventorLimits, lights_without_end) {
  const Folder folder;
  const Scene scene = load_mesh(folder.write("a.iv", doubling(12, "PointLight { }")));
  EXPECT_EQ(scene.lights.size(), 256u);
}

}  // namespace
}  // namespace raywalk::test
