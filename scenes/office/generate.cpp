// The office.
#include "scenes/generator.h"
#include "scenes/office/parts.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  office::add_shell(pieces);
  office::add_desk(pieces);
  office::add_desk_things(pieces);
  office::add_chairs(pieces);
  office::add_storage(pieces);
  office::add_rest(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_office_generator;
const Generator k_office_generator = {"office", 15'000, pour};

}  // namespace raywalk
