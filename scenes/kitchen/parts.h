// The parts of the kitchen and what they agree on. Metres, y up; the floor is y = 0.
#pragma once
#include "scenes/common/exact_math.h"
#include "scenes/common/links.h"
#include "scenes/common/solids.h"
#include "scenes/kitchen/materials.h"

namespace raywalk::kitchen {

constexpr float kSideX = 4.0f, kEndZ = 4.03f, kHeight = 4.03f;
constexpr float kUnit = 0.62f;                     // width of a cupboard
constexpr float kTop = 0.90f, kThick = 0.04f;      // of the worktop
constexpr float kDeep = 0.56f, kOverhang = 0.62f;  // of a base cupboard, and of the worktop above it
constexpr float kHighFrom = 1.50f, kHighTo = 2.36f, kHighDeep = 0.34f;  // wall cupboards
constexpr Vec3 kTable{1.15f, 0.0f, 0.55f};
constexpr float kTableTop = 0.92f;

constexpr float kSinkX = 0.30f, kSinkDeep = 0.19f;  // half the width of the sink, and its depth

/// An opening in a wall: along it from a to b, from y0 to y1.
struct Opening {
  float a, y0, b, y1;
};
constexpr Opening kSinkWindow{-1.0f, 1.16f, 1.0f, 2.70f};  // in the far wall, along x
constexpr Opening kSideWindow{-1.9f, 0.95f, 2.3f, 3.05f};  // in the right wall, along z

// Shares of triangles: flat surfaces need few, curved ones many.
constexpr double kFlat = 0.05, kSmooth = 8.0, kFine = 40.0, kTiny = 100.0;

void add_shell(Pieces& pieces);       // floor, walls, windows, tiles
void add_cupboards(Pieces& pieces);   // along two walls, and the worktop
void add_appliances(Pieces& pieces);  // sink, oven, hood, refrigerator
void add_table(Pieces& pieces);       // with bar stools and what is laid
void add_things(Pieces& pieces);      // pots and jars, lamps, a toy car

/// Cupboards stand against a wall: x to the right of somebody who faces it, z out of the wall.
Placement on_far_wall(float x);
Placement on_left_wall(float z);
/// A bow of metal from `from` to `to` that stands `out` off the place's surface (its z).
void add_handle(Pieces& pieces, const Placement& place, Vec3 from, Vec3 to, float out);

}  // namespace raywalk::kitchen
