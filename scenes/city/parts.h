// The parts of the city and what they agree on. Metres, y up; the street is y = 0.
#pragma once
#include "scenes/city/materials.h"
#include "scenes/common/exact_math.h"
#include "scenes/common/solids.h"

namespace raywalk::city {

constexpr float kPitch = 80.0f;      // from block to block
constexpr float kHalfBlock = 32.0f;  // half the side of a block; the rest is street
constexpr float kKerb = 0.15f;

// Shares of triangles: flat surfaces need few, leaves and the statue many.
constexpr double kFlat = 0.001, kSmooth = 20.0, kFine = 300.0;

/// One building on a lot of the given half size; `core` is 1 in the centre of the city and falls off outwards.
void add_building(Pieces& pieces, Vec3 at, float half_lot, float core, Random& random);
/// Trees, lamps, cars and road markings of one block.
void add_street(Pieces& pieces, Vec3 centre, Random& random);
void add_tree(Pieces& pieces, Vec3 at, float height, Random& random);
/// The square in the middle: lawn, trees, the statue and what small things lie around it.
void add_square(Pieces& pieces, Random& random);

}  // namespace raywalk::city
