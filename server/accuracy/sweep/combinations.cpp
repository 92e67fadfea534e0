// Options completed, structures built, what is equal left out.
#include "server/accuracy/sweep/combinations.h"

#include <algorithm>
#include <set>

#include "server/device/knobs.h"

namespace raywalk::accuracy {
namespace {

constexpr const char* kIntersector = "intersector";
constexpr const char* kSpawn = "spawn";
constexpr const char* kRecords = "triangles";

Combination combination(const KindInfo& kind, const TraversalInfo& traversal, const GivenOptions& set) {
  Combination out;
  out.structure_kind = kind.name;
  out.traversal = traversal.name;
  out.kernel = complete_options(kind, traversal, set, "");
  out.changed = changed_options(traversal.options, out.kernel);
  out.is_strict = std::ranges::find(traversal.options, kIntersector, &Option::name) != traversal.options.end();
  for (const Option& option : traversal.options) {
    const std::string name(option.name);
    if (!is_knob(name)) continue;
    const double value = out.kernel.at(name);
    out.knobs[name] = shown_option(option, value);
    out.is_strict &= value == option.default_value;
  }
  return out;
}

}  // namespace

std::string Combination::spawn() const {
  const auto found = knobs.find(kSpawn);
  return found == knobs.end() ? std::string(spawn_rows().front().name) : std::get<std::string>(found->second);
}

RayJob Combination::job(std::span<const Ray> rays) const {
  RayJob job{structure.structure, traversal, rays, kernel};
  job.kernel.erase(kSpawn);
  return job;
}

GivenOptions builder_options(const KindInfo& kind, GivenOptions options, const OptionValues& kernel) {
  const auto records = std::ranges::find(kind.options, kRecords, &Option::name);
  if (records == kind.options.end() || options.contains(kRecords)) return options;
  for (const std::string_view choice : records->choices) {
    GivenOptions with = options;
    with.emplace(kRecords, std::string(choice));
    if (why_unfit(form_of(complete_options(kind, with, "")), kernel).empty()) return with;
  }
  return options;
}

std::vector<Combination> combinations(const AccuracySpec& spec, const std::vector<KindInfo>& kinds,
                                      const Build& build) {
  std::vector<Combination> all;
  for (const SweepTechnique& technique : spec.techniques) {
    const KindInfo& kind = kind_named(kinds, technique.structure, "");
    const TraversalInfo& traversal = traversal_named(kind, technique.traversal, "");
    for (const GivenOptions& set : knob_sets_of(spec, traversal)) {
      all.push_back(combination(kind, traversal, set));
      all.back().structure = build(kind.name, builder_options(kind, technique.options, all.back().kernel));
    }
  }
  return all;
}

std::vector<std::size_t> combinations_for(RayKind kind, const std::vector<Combination>& all) {
  std::set<std::string> seen;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Combination& one = all[i];
    std::string key = one.structure.id + "/" + one.traversal;
    for (const auto& [name, value] : one.kernel) {
      if (name != kSpawn || is_spawned(kind)) key += " " + name + "=" + std::to_string(value);
    }
    if (seen.insert(key).second) places.push_back(i);
  }
  return places;
}

}  // namespace raywalk::accuracy
