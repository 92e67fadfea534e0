// The uniform grid's options and help.
#include "kernels/accel/grid/kind.h"

#include "kernels/accel/build_records.h"
#include "kernels/accel/grid/build.h"

namespace raywalk::grid {
namespace {

BuiltStructure build_from_options(SceneView scene, const OptionValues& options) {
  const auto whole = [&](std::string_view name) { return static_cast<u32>(options.find(name)->second); };
  Config config;
  config.resolution[0] = whole("resolution_x");
  config.resolution[1] = whole("resolution_y");
  config.resolution[2] = whole("resolution_z");
  config.density = options.find("density")->second;
  config.insertion = whole("insertion") == 0 ? Insertion::kBounds : Insertion::kExact;
  config.triangles = triangles_of(options);
  return build(scene, config);
}

}  // namespace

const Kind& kind() {
  static const Config defaults;
  static const Kind grid{
      .name = "grid",
      .help = "Uniform grid: a list of triangles for each of equal cells. Best for evenly filled scenes.",
      .options = {{.name = "resolution_x",
                   .help = "cells along x; 0: chosen by density",
                   .max = kMaxResolution,
                   .integer = true},
                  {.name = "resolution_y",
                   .help = "cells along y; 0: chosen by density",
                   .max = kMaxResolution,
                   .integer = true},
                  {.name = "resolution_z",
                   .help = "cells along z; 0: chosen by density",
                   .max = kMaxResolution,
                   .integer = true},
                  {.name = "density",
                   .help = "cells a triangle, where the resolution is not given",
                   .default_value = defaults.density,
                   .min = 0.01,
                   .max = 100},
                  {.name = "insertion",
                   .help = "cells of a triangle: those its bounds overlap, or those it overlaps",
                   .max = 1,
                   .integer = true,
                   .choices = {"bounds", "exact"}},
                  triangles_option()},
      .build = build_from_options,
  };
  return grid;
}

}  // namespace raywalk::grid
