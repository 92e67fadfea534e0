// The conference room.
#include "scenes/conference/parts.h"
#include "scenes/generator.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  conference::add_shell(pieces);
  conference::add_windows(pieces);
  conference::add_ceiling(pieces);
  conference::add_table(pieces);
  conference::add_chairs(pieces);
  conference::add_furniture(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_conference_generator;
const Generator k_conference_generator = {"conference", 60'000, pour};

}  // namespace raywalk
