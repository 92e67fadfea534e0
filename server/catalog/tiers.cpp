// The table of the tiers' knobs.
#include "server/catalog/tiers.h"

#include <algorithm>
#include <stdexcept>

namespace raywalk {
namespace {

/// Null for an option that the traversal has not.
const Option* option_named(const TraversalInfo& traversal, std::string_view name) {
  const auto found = std::ranges::find(traversal.options, name, &Option::name);
  return found == traversal.options.end() ? nullptr : &*found;
}

double value_in(Tier tier, const TierKnob& knob, const Option& option) {
  return tier == Tier::fast ? choice_value(option, knob.fast) : option.default_value;
}

}  // namespace

const char* tier_name(Tier tier) {
  switch (tier) {
    case Tier::strict:
      return "strict";
    case Tier::fast:
      return "fast";
    case Tier::automatic:
      return "auto";
  }
  return "strict";
}

double limit_ppm(Tier tier) {
  return tier == Tier::fast ? 1.0 : 0.0;
}

const std::vector<TierKnob>& tier_knobs() {
  // Spawn offsets cost the same within 2 %, and no other than the error bound knows how far a triangle's errors reach.
  static const std::vector<TierKnob> knobs = {
      {"intersector", "moeller-trumbore", true}, {"slab", "plain", true}, {"spawn", "error-bound", false}};
  return knobs;
}

bool has_tiers(const TraversalInfo& traversal) {
  return std::ranges::any_of(tier_knobs(), [&](const TierKnob& knob) { return option_named(traversal, knob.option); });
}

OptionValues kernel_options(const KindInfo& kind, const TraversalInfo& traversal, Tier tier, const GivenOptions& given,
                            const std::string& pointer) {
  OptionValues values = complete_options(kind, traversal, given, pointer);
  for (const TierKnob& knob : tier_knobs()) {
    const Option* option = option_named(traversal, knob.option);
    const std::string name(knob.option);
    if (option && !given.contains(name)) values[name] = value_in(tier, knob, *option);
  }
  return values;
}

bool is_of_tier(const TraversalInfo& traversal, Tier tier, const OptionValues& options) {
  return std::ranges::all_of(tier_knobs(), [&](const TierKnob& knob) {
    const Option* option = option_named(traversal, knob.option);
    return !option || options.at(std::string(knob.option)) == value_in(tier, knob, *option);
  });
}

double choice_value(const Option& option, std::string_view choice) {
  const auto found = std::ranges::find(option.choices, choice);
  if (found == option.choices.end()) {
    throw std::logic_error(std::string(option.name) + " has no choice " + std::string(choice));
  }
  return static_cast<double>(found - option.choices.begin());
}

}  // namespace raywalk
