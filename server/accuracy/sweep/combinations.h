// Techniques with their structures and knobs: what a sweep measures in turns.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "server/accuracy/sweep/spec.h"
#include "server/catalog/structures.h"

namespace raywalk::accuracy {

struct Combination {
  std::string structure_kind, traversal;
  StructureRecord structure;
  OptionValues kernel;     // complete
  GivenOptions knobs;      // the knobs among these, as a request would give them
  std::string changed;     // those that are not the default: " name=value" each
  bool is_strict = false;  // all are, and the triangle test is one of ours

  std::string name() const { return structure_kind + "/" + traversal + changed; }
  /// Name of the spawn offset; that of the default where the traversal has none.
  std::string spawn() const;
  /// For lists of rays: they start where the spawn offset has put them, so no kernel is compiled for it.
  RayJob job(std::span<const Ray> rays) const;
};

/// With the records of triangles that a traversal with these complete kernel options reads, unless `options` says.
GivenOptions builder_options(const KindInfo& kind, GivenOptions options, const OptionValues& kernel);

using Build = std::function<StructureRecord(const std::string& kind, const GivenOptions& options)>;

/// All of a checked sweep. `build` gives the structure of a kind with options, whether or not it was there before.
std::vector<Combination> combinations(const AccuracySpec& spec, const std::vector<KindInfo>& kinds, const Build& build);

/// Places of those that differ on rays of this kind: the spawn offset counts for spawned rays alone.
std::vector<std::size_t> combinations_for(RayKind kind, const std::vector<Combination>& all);

}  // namespace raywalk::accuracy
