// The parts of the museum and what they agree on. Metres, y up; the floor is y = 0.
#pragma once
#include "scenes/common/exact_math.h"
#include "scenes/common/links.h"
#include "scenes/common/solids.h"
#include "scenes/museum/materials.h"

namespace raywalk::museum {

constexpr float kSideX = 5.0f, kEndZ = 7.465f, kCrown = 6.056f;  // half width, half length, height of the vault
constexpr float kRowX = 3.3f, kBay = 2.9f;                       // rows of columns, and from column to column
constexpr float kSpringing = 4.55f;                              // where the vault starts; also the aisles' height

// Shares of triangles: flat surfaces need few, curved ones many.
constexpr double kFlat = 0.02, kCurved = 6.0, kFine = 40.0, kFinest = 110.0;

void add_hall(Pieces& pieces);      // floor, walls, columns, vault
void add_pictures(Pieces& pieces);  // on the walls, and the mirror at the end
void add_exhibits(Pieces& pieces);  // the knot in the middle, its rope, benches, glass and chrome

}  // namespace raywalk::museum
