// The fitted kitchen.
#include "scenes/generator.h"
#include "scenes/kitchen/parts.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  kitchen::add_shell(pieces);
  kitchen::add_cupboards(pieces);
  kitchen::add_appliances(pieces);
  kitchen::add_table(pieces);
  kitchen::add_things(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_kitchen_generator;
const Generator k_kitchen_generator = {"kitchen", 30'000, pour};

}  // namespace raywalk
