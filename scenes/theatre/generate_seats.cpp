// Rows of folding seats in the stalls and on the balcony.
#include "scenes/theatre/parts.h"

namespace raywalk::theatre {
namespace {

constexpr float kSeatPitch = 0.6f;

/// Faces local +z; its right-hand armrest belongs to it.
void add_seat(Pieces& pieces, const Placement& place, bool tipped_up) {
  add_pad(pieces, place, {0.0f, 0.74f, -0.20f}, {0.265f, 0.27f, 0.055f}, 0.05f, kSeat, 1, Ends::open);
  if (tipped_up) {
    add_pad(pieces, place, {0.0f, 0.62f, -0.08f}, {0.25f, 0.21f, 0.05f}, 0.045f, kSeat, 1, Ends::open);
  } else {
    add_pad(pieces, place, {0.0f, 0.43f, 0.05f}, {0.25f, 0.055f, 0.22f}, 0.05f, kSeat, 1, Ends::open);
  }
  add_plate(pieces, place.point({0.26f, 0.36f, -0.262f}), place.direction({-0.52f, 0.0f, 0.0f}), {0.0f, 0.62f, 0.0f},
            kSeatShell);
  add_block(pieces, place, {-0.32f, 0.58f, -0.24f}, {-0.275f, 0.63f, 0.20f}, kSeatShell);
  add_plate(pieces, place.point({-0.30f, 0.0f, -0.14f}), place.direction({0.0f, 0.0f, 0.18f}), {0.0f, 0.58f, 0.0f},
            kLampMetal);
}

/// One row between the aisles: blocks of seats from angle to angle, given as distances along the arc.
void add_row(Pieces& pieces, float radius, float floor, const std::vector<std::pair<float, float>>& blocks,
             Random& random) {
  const double turns_per_metre = 1.0 / (kTau * radius);
  for (const auto& [from, to] : blocks) {
    const int seats = static_cast<int>((to - from) / kSeatPitch + 0.01f);
    const float spare = (to - from) - kSeatPitch * static_cast<float>(seats);
    for (int i = 0; i < seats; ++i) {
      const double turns = turns_per_metre * (from + 0.5 * spare + kSeatPitch * (i + 0.5));
      const Vec3 at = {radius * static_cast<float>(sine_turns(turns)), floor,
                       kAxisZ + radius * static_cast<float>(cosine_turns(turns))};
      add_seat(pieces, Placement::at(at, turns + 0.5), random.unit() < 0.3f);
    }
  }
}

}  // namespace

void add_seats(Pieces& pieces) {
  Random random(1);
  for (int row = 0; row < kRows; ++row) {
    // Aisles at the walls and two between: the middle block is the widest.
    const float edge = 8.15f + 0.02f * static_cast<float>(row);
    add_row(pieces, kFirstRow + kRowPitch * static_cast<float>(row), row_floor(row),
            {{-edge, -4.2f}, {-3.0f, 3.0f}, {4.2f, edge}}, random);
  }
  for (int row = 0; row < 2; ++row) {
    const float radius = kBalconyFront + 1.2f + 1.05f * static_cast<float>(row);
    add_row(pieces, radius, kBalconyFloor + kBalconyRise * static_cast<float>(row), {{-7.6f, -0.6f}, {0.6f, 7.6f}},
            random);
  }
}

}  // namespace raywalk::theatre
