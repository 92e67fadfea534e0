// The theatre.
#include "scenes/generator.h"
#include "scenes/theatre/parts.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  theatre::add_house(pieces);
  theatre::add_stage(pieces);
  theatre::add_seats(pieces);
  theatre::add_balcony(pieces);
  theatre::add_lamps(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_theatre_generator;
const Generator k_theatre_generator = {"theatre", 15'000, pour};

}  // namespace raywalk
