// The parts of the theatre and what they agree on. Metres, y up; the stage is at small z.
#pragma once
#include "scenes/common/exact_math.h"
#include "scenes/common/sheets.h"
#include "scenes/theatre/materials.h"

namespace raywalk::theatre {

constexpr float kHalfWidth = 9.0f, kHeight = 8.0f, kHalfLength = 11.48f;

// The stage and its opening.
constexpr float kStage = 1.05f, kProscenium = -5.6f;
constexpr float kArchHalf = 5.9f, kArchSpring = 4.1f, kArchCrown = 6.5f;
/// The rim of the opening in the plane of the proscenium, from the left foot over the crown to the right one.
Vec3 on_arch(float t, float wider = 0.0f);

// Rows are arcs around an axis behind the stage.
constexpr float kAxisZ = -20.0f, kFirstRow = 18.0f, kRowPitch = 0.95f;
constexpr int kRows = 11;
constexpr float kBalconyFront = 24.7f, kBalconyFloor = 4.15f, kBalconyRise = 0.42f;
/// Where the arc of that radius passes x.
inline float arc_z(float radius, float x) {
  return kAxisZ + square_root(radius * radius - x * x);
}
inline float row_floor(int row) {
  const float i = static_cast<float>(row);
  return 0.09f * i + 0.009f * i * i;
}

void add_house(Pieces& pieces);    // walls, ceiling, stepped floor, doors
void add_stage(Pieces& pieces);    // boards, proscenium, curtains, piano
void add_seats(Pieces& pieces);    // stalls and balcony
void add_balcony(Pieces& pieces);  // balcony and boxes, without seats
void add_lamps(Pieces& pieces);    // chandelier, wall lamps, stage lamps

}  // namespace raywalk::theatre
