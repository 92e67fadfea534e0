// Stand-ins for the study's rooms: in proportion with the grids that the study reports.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "server/scene/catalog_files.h"
#include "tests/scene/files.h"

namespace raywalk::test {
namespace {

struct Room {
  const char* name;
  std::array<float, 3> grid_cells;  // longest first
};
void PrintTo(const Room& room, std::ostream* out) {
  *out << room.name;
}

class Rooms : public testing::TestWithParam<Room> {};

TEST_P(Rooms, have_the_proportions_of_the_studys_grid) {
  const Vec3 extent = bounds_of(load_scene(GetParam().name, scenes_dir(), "no-data")).extent();
  std::array<float, 3> sides = {extent.x, extent.y, extent.z};
  std::sort(sides.rbegin(), sides.rend());
  EXPECT_EQ(sides[2], extent.y) << "the height is the smallest";
  const std::array<float, 3>& cells = GetParam().grid_cells;
  EXPECT_NEAR(sides[0] / sides[2], cells[0] / cells[2], 0.02f * cells[0] / cells[2]);
  EXPECT_NEAR(sides[1] / sides[2], cells[1] / cells[2], 0.02f * cells[1] / cells[2]);
}

INSTANTIATE_TEST_SUITE_P(, Rooms,
                         testing::Values(Room{"theatre", {172, 135, 60}}, Room{"office", {93, 93, 55}},
                                         Room{"conference", {387, 246, 93}}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace raywalk::test
