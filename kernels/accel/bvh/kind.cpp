// Host only: the binary BVH's name, options and help.
#include "kernels/accel/build_records.h"
#include "kernels/accel/bvh/build.h"
#include "kernels/accel/bvh/layout.h"
#include "kernels/accel/bvh/split.h"

namespace raywalk::bvh {
namespace {

#define RW_NODES_HELP(type, name, help) "; " name ": " help
constexpr std::string_view kNodesHelp = "precision of the nodes, hits are the same" RW_NODE_FORMATS(RW_NODES_HELP);
#undef RW_NODES_HELP
#define RW_NODES_NAME(type, name, help) name,

BuiltStructure build_with(SceneView scene, const OptionValues& options) {
  Config config;
  config.bins = static_cast<u32>(options.at("bins"));
  config.max_leaf = static_cast<u32>(options.at("max_leaf"));
  config.traversal_cost = static_cast<float>(options.at("traversal_cost"));
  config.intersection_cost = static_cast<float>(options.at("intersection_cost"));
  config.triangles = triangles_of(options);
  config.nodes = static_cast<NodeFormat>(static_cast<u32>(options.at("nodes")));
  return build(scene, config);
}

}  // namespace

const Kind& kind() {
  static const Config defaults;
  static const Kind bvh{
      .name = "bvh",
      .help = "Binary bounding volume hierarchy, built top-down by the surface area heuristic over binned centroids.",
      .options = {{.name = "bins",
                   .help = "Candidate planes along each axis; more give a slightly better tree and a slower build.",
                   .default_value = static_cast<double>(defaults.bins),
                   .min = 2,
                   .max = kMaxBins,
                   .integer = true},
                  {.name = "max_leaf",
                   .help = "Most triangles in a leaf.",
                   .default_value = static_cast<double>(defaults.max_leaf),
                   .min = 1,
                   .max = kMaxLeaf,
                   .integer = true},
                  {.name = "traversal_cost",
                   .help = "Cost of a step through an inner node, in any unit shared with intersection_cost.",
                   .default_value = defaults.traversal_cost,
                   .min = 0.01,
                   .max = 100},
                  {.name = "intersection_cost",
                   .help = "Cost of a triangle test, in any unit shared with traversal_cost.",
                   .default_value = defaults.intersection_cost,
                   .min = 0.01,
                   .max = 100},
                  triangles_option(),
                  {.name = "nodes", .help = kNodesHelp, .integer = true, .choices = {RW_NODE_FORMATS(RW_NODES_NAME)}}},
      .build = build_with,
  };
  return bvh;
}

}  // namespace raywalk::bvh
