// The kd-tree's options and help.
#include "kernels/accel/kdtree/kind.h"

#include "kernels/accel/build_records.h"
#include "kernels/accel/kdtree/build.h"

namespace raywalk::kdtree {
namespace {

BuiltStructure build_from_options(SceneView scene, const OptionValues& options) {
  Config config;
  config.sah = options.find("sah")->second == 0 ? Sah::kExact : Sah::kSampled;
  config.traversal_cost = options.find("traversal_cost")->second;
  config.intersection_cost = options.find("intersection_cost")->second;
  config.empty_bonus = options.find("empty_bonus")->second;
  config.triangles = triangles_of(options);
  return build(scene, config);
}

}  // namespace

const Kind& kind() {
  static const Config defaults;
  static const Kind kdtree{
      .name = "kdtree",
      .help = "kd-tree by the surface area heuristic, 8-byte nodes. Best for incoherent rays.",
      .options = {{.name = "sah",
                   .help = "split planes: all bounds of triangles, or borders of bins filled by a sample",
                   .max = 1,
                   .integer = true,
                   .choices = {"exact", "sampled"}},
                  {.name = "traversal_cost",
                   .help = "cost of a node's visit",
                   .default_value = defaults.traversal_cost,
                   .min = 0.01,
                   .max = 1000},
                  {.name = "intersection_cost",
                   .help = "cost of a triangle's test",
                   .default_value = defaults.intersection_cost,
                   .min = 0.01,
                   .max = 1000},
                  {.name = "empty_bonus",
                   .help = "fraction taken off the cost of a split that cuts off empty space",
                   .default_value = defaults.empty_bonus,
                   .max = 0.9},
                  triangles_option()},
      .build = build_from_options,
  };
  return kdtree;
}

}  // namespace raywalk::kdtree
