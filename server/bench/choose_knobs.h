// Tier auto of a benchmark: measures sets of knobs on its scene before the measurement itself.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "server/bench/comparison.h"
#include "server/bench/knob_choice.h"

namespace raywalk {

/// Candidates that differ from strict in one knob that tier auto tries and `given` does not fix, where a structure of
/// that form takes it; strict, `base`, first.
std::vector<Candidate> single_changes(const TraversalInfo& traversal, const StructureForm& form,
                                      const OptionValues& base, const GivenOptions& given);
/// All combinations of those of the changes that were measured to be faster than strict; strict first.
std::vector<Candidate> combinations(const TraversalInfo& traversal, std::span<const Candidate> singles);

/// Gives every subject of tier auto that has knobs the ones that are cheapest for it, and its `choice`. Waits for the
/// device and holds it while it measures. `before_launch` gets the subject's number; what it throws ends it.
void choose_knobs(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<Subject> subjects,
                  const std::vector<KindInfo>& kinds, Comparison& comparison, DeviceQueue& queue,
                  const std::function<void(std::size_t subject)>& before_launch);

}  // namespace raywalk
