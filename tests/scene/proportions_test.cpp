// Stand-ins fill boxes of the shapes that the study's grids had.
#include <gtest/gtest.h>

#include "scenes/generator.h"
#include "server/scene/sinks.h"

namespace raywalk::test {
namespace {

struct Studied {
  const char* name;
  u64 triangles;
  Vec3 cells;
};

class Proportions : public testing::TestWithParam<Studied> {};

TEST_P(Proportions, are_those_of_the_study) {
  Scene scene;
  SceneSink sink(scene);
  generate(*find_generator(GetParam().name), GetParam().triangles, sink);
  Box box;
  for (const Vec3& p : scene.positions) box.add(p);
  const Vec3 size = box.extent(), cells = GetParam().cells;
  // A cell is a cube but for rounding to whole cells.
  const float cell = size.y / cells.y;
  EXPECT_NEAR(size.x / cell, cells.x, 0.03f * cells.x);
  EXPECT_NEAR(size.z / cell, cells.z, 0.03f * cells.z);
}

INSTANTIATE_TEST_SUITE_P(, Proportions,
                         testing::Values(Studied{"robots", 71'708, {128, 209, 268}},
                                         Studied{"museum", 14'380, {71, 43, 106}},
                                         Studied{"kitchen", 110'559, {254, 128, 256}},
                                         Studied{"buddha", 200'000, {128, 312, 129}}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace raywalk::test
