// The parts of the conference room and what they agree on. Metres, y up; the windows are in the wall z = -kHalfDepth,
// the screen hangs on the wall x = -kHalfLength.
#pragma once
#include "scenes/common/exact_math.h"
#include "scenes/common/sheets.h"
#include "scenes/conference/materials.h"

namespace raywalk::conference {

constexpr float kHalfLength = 6.24f, kHalfDepth = 3.967f, kHeight = 3.0f;
constexpr float kTableTop = 0.74f;

/// The table's rim, or a line around it at that distance for a positive `out`; t in [0, 1], turning left from above.
Vec3 on_table(double t, float out = 0.0f);

/// A seat at the table: the point of the rim before it, the direction to the table and its turns around y from +z.
struct Seat {
  Vec3 rim;
  Vec3 inwards;
  double turns;
};
constexpr int kSeats = 24;
Seat seat_at(int i);

void add_shell(Pieces& pieces);      // floor, walls, panels, doors
void add_windows(Pieces& pieces);    // with curtains
void add_ceiling(Pieces& pieces);    // tiles, vents, pendants, projector
void add_table(Pieces& pieces);      // with what lies on it
void add_chairs(Pieces& pieces);     // around the table
void add_furniture(Pieces& pieces);  // screen, whiteboard, sideboard, plants, pictures

}  // namespace raywalk::conference
