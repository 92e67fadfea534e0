// Defaults of a sweep, and what is wrong with a request for one.
#include "server/accuracy/sweep/spec.h"

#include <algorithm>

#include "server/accuracy/sweep/combinations.h"
#include "server/device/knobs.h"
#include "server/system/refusal.h"

namespace raywalk::accuracy {
namespace {

constexpr std::string_view kBrute = "brute";  // what others are compared with
constexpr u32 kAllKnobs = ~0u;

const Option* option_named(const TraversalInfo& traversal, std::string_view name) {
  const auto found = std::ranges::find(traversal.options, name, &Option::name);
  return found == traversal.options.end() ? nullptr : &*found;
}

/// Its choices, the default first; an empty one where the traversal lacks the knob.
std::vector<std::string> choices_of(const TraversalInfo& traversal, std::string_view name) {
  const Option* option = option_named(traversal, name);
  if (option == nullptr) return {""};
  std::vector<std::string> names(option->choices.begin(), option->choices.end());
  const auto strict = names.begin() + static_cast<std::ptrdiff_t>(option->default_value);
  std::rotate(names.begin(), strict, strict + 1);
  return names;
}

bool has_all(const TraversalInfo& traversal, const GivenOptions& set) {
  return std::ranges::all_of(set, [&](const auto& one) { return option_named(traversal, one.first) != nullptr; });
}

std::vector<GivenOptions> default_sets(const TraversalInfo& traversal, bool quick) {
  const std::vector<std::string> intersectors = choices_of(traversal, "intersector");
  const std::vector<std::string> slabs = choices_of(traversal, "slab");
  const std::vector<std::string> spawns = choices_of(traversal, "spawn");
  std::vector<GivenOptions> sets;
  for (std::size_t i = 0; i < intersectors.size(); ++i) {
    for (std::size_t s = 0; s < slabs.size(); ++s) {
      if (quick && i > 0 && s > 0) continue;
      GivenOptions& set = sets.emplace_back();
      if (i > 0) set["intersector"] = intersectors[i];
      if (s > 0) set["slab"] = slabs[s];
    }
  }
  for (std::size_t i = 1; i < spawns.size(); ++i) sets.push_back({{"spawn", spawns[i]}});
  return sets;
}

void check_knob_set(const AccuracySpec& spec, std::size_t index, const std::vector<KindInfo>& kinds) {
  const GivenOptions& set = spec.knob_sets[index];
  const std::string pointer = "/spec/knob_sets/" + std::to_string(index);
  std::vector<const TraversalInfo*> traversals;
  bool fits = false;
  for (const SweepTechnique& technique : spec.techniques) {
    const KindInfo& kind = kind_named(kinds, technique.structure, pointer);
    traversals.push_back(&traversal_named(kind, technique.traversal, pointer));
    if (!has_all(*traversals.back(), set)) continue;
    const OptionValues kernel = complete_options(kind, *traversals.back(), set, pointer);
    const GivenOptions builder = builder_options(kind, technique.options, kernel);
    check_form(form_of(complete_options(kind, builder, "")), kernel, pointer + "/intersector");
    fits = true;
  }
  if (fits) return;
  for (const auto& [name, value] : set) {
    const auto has = [&name = name](const TraversalInfo* t) { return option_named(*t, name) != nullptr; };
    if (std::ranges::any_of(traversals, has)) continue;
    throw Refusal(Refusal::Why::invalid, "unknown_option", "No technique of the sweep has an option '" + name + "'.")
        .at(pointer + "/" + name);
  }
  throw Refusal(Refusal::Why::invalid, "unknown_option", "No technique of the sweep has all options of this set.")
      .at(pointer);
}

}  // namespace

const char* name_of(RayKind kind) {
  constexpr const char* kNames[] = {"primary", "shadow", "diffuse", "random", "edge", "vertex"};
  return kNames[static_cast<u32>(kind)];
}

bool is_knob(const std::string& name) {
  static const std::vector<Option> knobs = knob_options(kAllKnobs);
  return std::ranges::find(knobs, name, &Option::name) != knobs.end();
}

std::vector<GivenOptions> knob_sets_of(const AccuracySpec& spec, const TraversalInfo& traversal) {
  if (spec.knob_sets.empty()) return default_sets(traversal, spec.quick);
  std::vector<GivenOptions> sets;
  for (const GivenOptions& set : spec.knob_sets) {
    if (has_all(traversal, set)) sets.push_back(set);
  }
  return sets;
}

AccuracySpec checked(AccuracySpec spec, const Scenes& scenes, const std::vector<KindInfo>& kinds) {
  if (!spec.scene.empty()) scenes.find(spec.scene, "/spec/scene");
  if (spec.scene.empty() && !spec.hard_cases) {
    throw Refusal(Refusal::Why::invalid, "nothing_to_do", "Without a scene and without the hard cases nothing is left.")
        .at("/spec/hard_cases");
  }
  if (spec.techniques.empty()) {
    for (const KindInfo& kind : kinds) {
      if (kind.name == kBrute) continue;
      for (const TraversalInfo& traversal : kind.traversals) {
        if (!traversal.baseline) spec.techniques.push_back({kind.name, traversal.name});
      }
    }
  }
  for (std::size_t i = 0; i < spec.techniques.size(); ++i) {
    const SweepTechnique& technique = spec.techniques[i];
    const std::string pointer = "/spec/techniques/" + std::to_string(i);
    const KindInfo& kind = kind_named(kinds, technique.structure, pointer + "/structure");
    const TraversalInfo& traversal = traversal_named(kind, technique.traversal, pointer + "/traversal");
    complete_options(kind, technique.options, pointer + "/options");
    if (traversal.baseline) {
      throw Refusal(Refusal::Why::invalid, "baseline_takes_no_rays",
                    kind.name + "/" + traversal.name + " is a baseline: it takes no lists of rays.")
          .at(pointer + "/traversal");
    }
  }
  for (std::size_t i = 0; i < spec.knob_sets.size(); ++i) check_knob_set(spec, i, kinds);
  return spec;
}

}  // namespace raywalk::accuracy
