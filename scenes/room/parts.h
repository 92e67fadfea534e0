// The parts of the room and what they agree on. Metres, y up; the floor is y = 0.
#pragma once
#include "scenes/common/exact_math.h"
#include "scenes/common/solids.h"
#include "scenes/room/materials.h"

namespace raywalk::room {

constexpr float kLeftX = -3.0f, kRightX = 3.0f, kFrontZ = -2.5f, kBackZ = 2.5f, kHeight = 2.7f;
struct Opening {
  float x0, y0, x1, y1;
};
constexpr Opening kWindow{0.95f, 0.90f, 2.25f, 2.15f};
constexpr float kTableTop = 0.74f;
constexpr Vec3 kTableCentre{0.3f, 0.0f, 0.1f};

// Shares of triangles: flat surfaces need few, curved and rough ones many.
constexpr double kFlat = 0.2, kSmooth = 12.0, kFine = 60.0;

void add_shell(Pieces& pieces);
void add_seating(Pieces& pieces);    // table, chairs, sofa, rug
void add_shelf(Pieces& pieces);      // with its books
void add_ornaments(Pieces& pieces);  // what stands on the table and around: glass, lamps, plant, statue

}  // namespace raywalk::room
