// The BART scenes against figures that were computed apart from this program: counts, boxes and their cameras.
#include <array>
#include <chrono>
#include <cstdlib>

#include "tests/scene/aff_file.h"

namespace raywalk::test {
namespace {

struct CameraSample {
  Vec3 eye, view, up;
};

struct Original {
  const char* name;
  const char* file;
  size_t triangles, without_area;
  Box bounds;
  std::array<CameraSample, 11> camera;  // at even times from the first frame to the last
};

void PrintTo(const Original& original, std::ostream* out) {
  *out << original.name;
}

// The counts are without the eight legs of the museum's paintings (cones), as the study's are.
const std::vector<Original>& originals() {
  static const std::vector<Original> all = {
      // clang-format off
      {"robots",
       "robots/aff/Robot.aff",
       71708u,
       128u,
       {{-164.148, -0.6197637, -435.355}, {164.148, 535.355, 250.097}},
       {{
         {{-3.5, 2, -203}, {0.05881797, 0.09871758, -0.9933757}, {-0.005843746, 0.9951155, 0.09854446}},
         {{-3.713534, 1.202806, -204.3222}, {0.07817697, -0.01935189, -0.9967517}, {0.002458251, 0.9998123, -0.01921851}},
         {{4.879078, 17.17828, -162.1581}, {-0.5152984, -0.2568489, -0.8176161}, {-0.08615197, 0.9647246, -0.2487653}},
         {{-3.099566, 8.629064, -151.243}, {-0.9702494, -0.001653832, 0.2420886}, {-0.01482163, 0.9985067, -0.05258068}},
         {{5.765592, 6.706506, -98.78137}, {0.4446024, -0.07125938, 0.892889}, {0.03193291, 0.9974578, 0.06370419}},
         {{-3, 26, -26}, {0.05233596, 0, 0.9986295}, {0, 1, 0}},
         {{0, 6, 74}, {0.05233596, 0, 0.9986295}, {0, 1, 0}},
         {{0, 18.89213, 81.03984}, {0.09715057, -0.08938568, -0.9912477}, {-0.006800846, 0.995876, -0.09046958}},
         {{0, 10, 0}, {0, 0, -1}, {0, 1, 0}},
         {{0, 80, 0}, {-0.1480099, -0.9427379, 0.04148516}, {-0.8996097, 0.208471, 0.2839947}},
         {{0, 80, 0}, {-0.1480099, -0.9427379, 0.04148516}, {-0.8996097, 0.208471, 0.2839947}},
       }}},
      {"museum",
       "museum/aff/museum6_derived.aff",
       14380u,
       0u,
       {{-5, -1.06782, -9.93844}, {5, 5, 5}},
       {{
         {{0, 1.8, -9}, {0, 0, 1}, {0, 1, 0}},
         {{0, 1.8, -9}, {0, 0, 1}, {0, 1, 0}},
         {{-0.128, 1.9536, -4.776}, {0.06697048, 0, 0.997755}, {0, 1, 0}},
         {{2.136, 2.2256, -2.1848}, {-0.7777879, 0.01289132, 0.6283946}, {0.02647665, 0.9995742, 0.01226522}},
         {{2.5725, 2.622, 0.89705}, {-0.8876448, -0.0851201, -0.4525939}, {-0.05264785, 0.9950831, -0.08389195}},
         {{0, 3, 4.9}, {0.02378058, -0.3254751, -0.9452515}, {3.946442e-07, 0.9455189, -0.3255672}},
         {{-3.28743, 2.157987, 1.679131}, {0.9017845, -0.100436, -0.4203538}, {0.07610319, 0.9943269, -0.07431259}},
         {{-3.246445, 1.543495, -1.322302}, {0.8450284, 0.1362737, 0.5170673}, {-0.1079606, 0.990547, -0.08462329}},
         {{-0.6863662, 1.434115, -3.561143}, {0.1715945, 0.290104, 0.9414913}, {-0.07667032, 0.9566943, -0.2808164}},
         {{0.03825451, 1.822905, -5.579243}, {0.2085861, 0.07305273, 0.9752744}, {-0.02831102, 0.9972395, -0.0686432}},
         {{0.0951733, 1.74933, -5.98824}, {0.1903458, -0.1013367, -0.9764729}, {-0.01331185, 0.9943003, -0.1057817}},
       }}},
      {"kitchen",
       "kitchen/aff/kitchen.aff",
       110561u,
       41u,
       {{-2, -1.1, -3.75}, {6, 2.9, 4.33}},
       {{
         {{3.75, 2.3, 3.6}, {-0.3134634, -0.419813, -0.8517615}, {-0.1270025, 0.9074443, -0.4005185}},
         {{3.64991, 1.459248, 2.155761}, {-0.9636261, -0.2636048, -0.04401171}, {-0.2495061, 0.9463628, -0.2052906}},
         {{3.543214, 0.562997, 0.6476816}, {-0.4385119, -0.03724263, 0.8979533}, {-0.1049861, 0.9944231, -0.01002585}},
         {{3.457341, 0.1468574, 0.3061123}, {0.1177261, 0.001141679, 0.9930454}, {0.01518781, 0.9998803, -0.002950061}},
         {{3.765907, 0.2265346, 1.053385}, {-0.996586, -0.07359093, -0.03742481}, {-0.07228937, 0.9967688, -0.03501855}},
         {{3.117315, 0.4883333, 1.05}, {-0.6169609, -0.5799062, -0.5320413}, {-0.4512453, 0.8145421, -0.3645529}},
         {{1.76, 0.21, 1.3}, {-0.9895116, -0.1366474, 0.04681558}, {-0.1348508, 0.9900739, 0.03961052}},
         {{0.6461143, 0.2688031, 1.352007}, {0.9813806, -0.177632, 0.073066}, {0.1756866, 0.9839163, 0.03229479}},
         {{0.7261713, 0.1831822, 0.9650402}, {0.8883983, -0.141129, 0.4368393}, {0.1118553, 0.9894402, 0.09217672}},
         {{2.529016, 0.9605478, 1.990549}, {-0.561292, -0.1262055, -0.8179385}, {-0.09863849, 0.9914615, -0.08529109}},
         {{3.27488, 0.334545, 2.98028}, {-0.7173608, -0.4625461, 0.5210015}, {-0.3597269, 0.8863283, 0.2915793}},
       }}},
      // clang-format on
  };
  return all;
}

class AffOriginal : public testing::TestWithParam<Original> {
 protected:
  void SetUp() override {
    const char* data = std::getenv("RAYWALK_SCENE_DATA");
    if (data == nullptr) GTEST_SKIP() << "RAYWALK_SCENE_DATA names no folder of original scene data";
    file_ = std::filesystem::path(data) / GetParam().file;
    if (!std::filesystem::exists(file_)) GTEST_SKIP() << "RAYWALK_SCENE_DATA has no " << GetParam().file;
  }
  Scene load(u32 cone_slices) const {
    ImportSettings settings = aff_settings(file_.parent_path().parent_path());
    settings.cone_slices = cone_slices;
    return load_mesh(file_, settings);
  }
  std::filesystem::path file_;
};

TEST_P(AffOriginal, counts_and_bounds) {
  const auto begin = std::chrono::steady_clock::now();
  const Scene scene = load(0);
  RecordProperty(
      "load_ms",
      static_cast<int>(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count()));
  EXPECT_EQ(scene.triangles.size(), GetParam().triangles);
  size_t without_area = 0;
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const Vec3 a = position_of(scene, i, 0);
    without_area += length(cross(position_of(scene, i, 1) - a, position_of(scene, i, 2) - a)) == 0.0f;
  }
  EXPECT_EQ(without_area, GetParam().without_area);
  const Box box = bounds_of(scene);
  const float tolerance = 1e-4f * length(GetParam().bounds.extent());
  expect_near(box.lo, GetParam().bounds.lo, tolerance);
  expect_near(box.hi, GetParam().bounds.hi, tolerance);
  for (const std::string& warning : scene.warnings) EXPECT_EQ(warning.find("texture"), std::string::npos) << warning;
  EXPECT_EQ(scene.normals.size(), scene.positions.size());
  EXPECT_EQ(scene.texcoords.size(), scene.positions.size());
}

TEST_P(AffOriginal, camera) {
  const Scene scene = load(20);
  ASSERT_TRUE(scene.has_camera_path);
  EXPECT_EQ(scene.camera_path.frames, 400u);
  for (u32 i = 0; i < 11; ++i) {
    const CameraSample& expected = GetParam().camera[i];
    const CameraPose pose = pose_at(scene.camera_path, i, 11);
    expect_near(pose.eye, expected.eye, 1e-4f * larger(1.0f, length(expected.eye)));
    expect_near(normalized(pose.target - pose.eye), normalized(expected.view), 1e-4f);
    expect_near(pose.up, expected.up, 1e-4f);
  }
}

TEST_P(AffOriginal, cones_are_there_unless_they_are_left_out) {
  const size_t cones = std::string(GetParam().name) == "museum" ? 8 : 0;
  EXPECT_EQ(load(20).triangles.size(), GetParam().triangles + 40 * cones);
}

INSTANTIATE_TEST_SUITE_P(Bart, AffOriginal, testing::ValuesIn(originals()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace raywalk::test
