// A seated figure on a lotus, carved in stone.
#include "scenes/buddha/parts.h"
#include "scenes/generator.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  buddha::add_base(pieces);
  buddha::add_body(pieces);
  buddha::add_head(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_buddha_generator;
const Generator k_buddha_generator = {"buddha", 60'000, pour};

}  // namespace raywalk
