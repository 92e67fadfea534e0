// Robots in a city: small and full of detail in a large and nearly empty space.
#include "scenes/generator.h"
#include "scenes/robots/parts.h"

namespace raywalk {
namespace {

void pour(TriangleSink& sink, u64 triangles) {
  Pieces pieces;
  robots::add_city(pieces);
  robots::add_robots(pieces);
  pieces.add_to(sink, triangles);
}

}  // namespace

extern const Generator k_robots_generator;
const Generator k_robots_generator = {"robots", 50'000, pour};

}  // namespace raywalk
