// raywalk-generate: writes a procedural scene to a PLY file of any size.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "scenes/generator.h"
#include "server/scene/sinks.h"

int main(int argc, char** argv) {
  using namespace raywalk;
  std::string names;
  for (const Generator* g : generators()) names += (names.empty() ? "" : ", ") + std::string(g->name);

  CLI::App app("Writes a procedural scene as binary PLY, in memory that does not grow with it.");
  std::string name;
  u64 triangles = 0;
  std::string out;
  app.add_option("name", name, "Generator: " + names)->required();
  app.add_option("--triangles", triangles, "Exact number of triangles")->required();
  app.add_option("--out", out, "PLY file to write")->required();
  CLI11_PARSE(app, argc, argv);

  try {
    const Generator* generator = find_generator(name);
    if (generator == nullptr) throw std::invalid_argument("no generator '" + name + "' (there are " + names + ")");
    PlySink sink(out);
    generate(*generator, triangles, sink);
    sink.finish();
  } catch (const std::exception& e) {
    std::cerr << "raywalk-generate: " << e.what() << '\n';
    return 1;
  }
}
