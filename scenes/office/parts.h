// The parts of the office and what they agree on. Metres, y up; the floor is y = 0, the window in the wall z = -kHalf.
#pragma once
#include "scenes/common/exact_math.h"
#include "scenes/common/sheets.h"
#include "scenes/office/materials.h"

namespace raywalk::office {

constexpr float kHalf = 2.2f, kHeight = 2.6f;
constexpr float kDeskTop = 0.74f;
/// Triangles a square metre of what is upholstered.
constexpr double kSoft = 600.0;

/// A point of the unit circle in the plane y = 0.
inline Vec3 on_circle(double turns) {
  return {static_cast<float>(cosine_turns(turns)), 0.0f, -static_cast<float>(sine_turns(turns))};
}

void add_shell(Pieces& pieces);        // walls, floor, ceiling with its lamps, window with blinds, door
void add_desk(Pieces& pieces);         // the desk itself, drawers, what stands on it
void add_desk_things(Pieces& pieces);  // monitor, keyboard, lamp, telephone, mug
void add_chairs(Pieces& pieces);       // swivel chair, armchair, glass table
void add_storage(Pieces& pieces);      // bookshelf, filing cabinets
void add_rest(Pieces& pieces);         // plant, wastebasket, coat stand, pictures, clock

}  // namespace raywalk::office
