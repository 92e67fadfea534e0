// Accuracy tiers: named sets of a kernel's knobs.
#pragma once
#include <optional>

#include "server/catalog/build_options.h"

namespace raywalk {

/// `strict` is the default of every knob; `fast` may err in up to one ray of a million. `automatic` is what a benchmark
/// finds for its scene: until then it is strict.
enum class Tier { strict, fast, automatic };

/// As on the wire.
const char* tier_name(Tier tier);

/// Wrong answers that a tier allows, per million rays. `automatic` promises what strict does.
double limit_ppm(Tier tier);

/// A knob, and the choice that the fast tier makes.
struct TierKnob {
  std::string_view option;
  std::string_view fast;
  bool is_tried;  // whether `automatic` tries its other choices; else they are not safe on any scene
};
const std::vector<TierKnob>& tier_knobs();

/// Whether the traversal has any of the knobs; the tiers are nothing to others, such as those of another engine.
bool has_tiers(const TraversalInfo& traversal);

/// complete_options with the tier's knobs as defaults: what is `given` overrides them. Throws as that does.
OptionValues kernel_options(const KindInfo& kind, const TraversalInfo& traversal, Tier tier, const GivenOptions& given,
                            const std::string& pointer);

/// Whether the complete options have the knobs of this tier; other options do not matter.
bool is_of_tier(const TraversalInfo& traversal, Tier tier, const OptionValues& options);

/// The value of option `name` for a choice of it. Throws std::logic_error for one that it has not.
double choice_value(const Option& option, std::string_view choice);

}  // namespace raywalk
