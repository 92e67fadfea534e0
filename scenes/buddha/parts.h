// The parts of the statue and what they agree on. Lengths are those of the study's figure: two units tall, y up, facing
// +z, the ground at y = 0. Left and right are the figure's own: its left is +x.
#pragma once
#include "scenes/buddha/carving.h"
#include "scenes/buddha/materials.h"
#include "scenes/common/exact_math.h"
#include "scenes/common/links.h"
#include "scenes/common/solids.h"

namespace raywalk::buddha {

constexpr float kRadius = 0.4065f, kTop = 1.981f;  // of the base, and where the flame ends
constexpr float kSeat = 0.965f;                    // height of the lotus

// Share of triangles: as many for each bit of surface everywhere.
constexpr double kEven = 1.0, kRelief = 2.0;

void add_base(Pieces& pieces);  // and the lotus on it
void add_body(Pieces& pieces);  // crossed legs, torso, arms and hands
void add_head(Pieces& pieces);

}  // namespace raywalk::buddha
