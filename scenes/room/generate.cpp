// The furnished room.
#include "scenes/generator.h"
#include "scenes/room/parts.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  room::add_shell(pieces);
  room::add_seating(pieces);
  room::add_shelf(pieces);
  room::add_ornaments(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_room_generator;
const Generator k_room_generator = {"room", 20'000, pour};

}  // namespace raywalk
