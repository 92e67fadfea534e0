// Procedural scenes: one generator a folder of scenes/, deterministic to the bit, in bounded memory.
#pragma once
#include <span>
#include <string_view>

#include "server/scene/triangle_sink.h"

namespace raywalk {

struct Generator {
  const char* name;
  u64 least_triangles;
  /// Pours exactly `triangles`, without calling begin().
  void (*pour)(TriangleSink& sink, u64 triangles);
};

/// All that are compiled in, by name.
std::span<const Generator* const> generators();
/// nullptr if there is none of that name.
const Generator* find_generator(std::string_view name);

/// Runs dry once to count the vertices, then pours exactly `triangles` into the sink.
/// Throws std::invalid_argument if the generator cannot make so few or so many.
void generate(const Generator& generator, u64 triangles, TriangleSink& sink);

}  // namespace raywalk
