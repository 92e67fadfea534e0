// The table of generators, which CMake collects from the folders.
#include "scenes/generator.h"

#include <stdexcept>
#include <string>

namespace raywalk {

#define RAYWALK_GENERATOR(name) extern const Generator k_##name##_generator;
#include "generator_list.inc"
#undef RAYWALK_GENERATOR

namespace {

constexpr const Generator* kGenerators[] = {
#define RAYWALK_GENERATOR(name) &k_##name##_generator,
#include "generator_list.inc"
#undef RAYWALK_GENERATOR
};
constexpr u64 kMostTriangles = 1'000'000'000;  // vertex indices have 32 bits

}  // namespace

std::span<const Generator* const> generators() {
  return kGenerators;
}

const Generator* find_generator(std::string_view name) {
  for (const Generator* generator : kGenerators) {
    if (name == generator->name) return generator;
  }
  return nullptr;
}

void generate(const Generator& generator, u64 triangles, TriangleSink& sink) {
  if (triangles < generator.least_triangles || triangles > kMostTriangles) {
    throw std::invalid_argument(std::string(generator.name) + ": " + std::to_string(triangles) +
                                " triangles asked for, it can make " + std::to_string(generator.least_triangles) +
                                " to " + std::to_string(kMostTriangles));
  }
  CountingSink counter;
  generator.pour(counter, triangles);
  sink.begin(counter.counts());
  generator.pour(sink, triangles);
}

}  // namespace raywalk
