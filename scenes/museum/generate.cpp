// The museum's hall.
#include "scenes/generator.h"
#include "scenes/museum/parts.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  museum::add_hall(pieces);
  museum::add_pictures(pieces);
  museum::add_exhibits(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_museum_generator;
const Generator k_museum_generator = {"museum", 5'000, pour};

}  // namespace raywalk
