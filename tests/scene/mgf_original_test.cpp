// MGF: the study's office and other original scenes, where they are.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/scene/mgf_file.h"

namespace raywalk::test {
namespace {

struct Original {
  const char* file;
  size_t triangles, lights, warnings;
};

class MgfOriginal : public ::testing::TestWithParam<Original> {};

TEST_P(MgfOriginal, has_its_triangles_and_lights) {
  const Original& original = GetParam();
  const char* data = std::getenv("RAYWALK_SCENE_DATA");
  if (data == nullptr) GTEST_SKIP() << "RAYWALK_SCENE_DATA names no folder of original scene data";
  const std::filesystem::path file = std::filesystem::path(data) / original.file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << original.file << " in RAYWALK_SCENE_DATA";
  const Scene scene = load_mesh(file);
  EXPECT_EQ(scene.triangles.size(), original.triangles);
  EXPECT_EQ(scene.lights.size(), original.lights);
  EXPECT_EQ(scene.warnings.size(), original.warnings);
  const Box box = bounds_of(scene);
  for (const Light& light : scene.lights) {
    EXPECT_TRUE(is_finite(light.position) && is_finite(light.intensity));
    EXPECT_GE(smaller(light.position.x - box.lo.x, box.hi.x - light.position.x), -0.05f * box.extent().x);
  }
  if (std::string(original.file).ends_with("/office.mgf")) {
    ImportSettings settings;
    settings.sphere_slices = 15;
    settings.sphere_stacks = 14;
    EXPECT_EQ(load_mesh(file, settings).triangles.size(), 36310u) << "as the study counts";
    EXPECT_FLOAT_EQ(box.lo.x, -30 * 0.0762f);
    EXPECT_FLOAT_EQ(box.hi.y, 51 * 0.0762f);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, MgfOriginal,
    ::testing::Values(Original{"office/office.mgf", 34000, 3, 0}, Original{"mgf_extra/graz.mgf", 27069, 4, 3},
                      Original{"mgf_extra/corridor.mgf", 1376, 16, 1}, Original{"mgf_extra/classroom.mgf", 9253, 16, 1},
                      Original{"mgf_extra/office2.mgf", 741, 1, 0}, Original{"mgf_extra/examp1.mgf", 500, 2, 0},
                      Original{"mgf_extra/cube.mgf", 67, 1, 0}, Original{"mgf_extra/Materials/test.mgf", 4, 1, 0}));

}  // namespace
}  // namespace raywalk::test
