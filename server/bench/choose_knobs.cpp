// First each knob alone, then what is faster in combination: all candidates of a round take turns.
#include "server/bench/choose_knobs.h"

#include <algorithm>

#include "server/bench/measure.h"
#include "server/bench/statistics.h"
#include "server/device/knobs.h"

namespace raywalk {
namespace {

constexpr u32 kFrames = 4, kRepeats = 5;
constexpr double kRoundSeconds = 15;  // a round ends early after them

/// Some evenly spaced frames of the walkthrough, with one set of knobs.
class SpacedFrames : public Technique {
 public:
  SpacedFrames(DeviceQueue::Hold& hold, const BenchmarkSpec& spec, const LoadedScene& scene, Subject subject)
      : spec_(spec), subject_(std::move(subject)), technique_(hold, spec, scene, subject_) {}
  SpacedFrames(const SpacedFrames&) = delete;
  SpacedFrames& operator=(const SpacedFrames&) = delete;
  double measure(u32 first, u32 frames) override {
    return technique_.measure(spaced_frame(first, std::min(kFrames, spec_.frames), spec_.frames), frames);
  }

 private:
  const BenchmarkSpec& spec_;
  Subject subject_;
  DeviceTechnique technique_;
};

Subject with_knobs(Subject subject, const OptionValues& kernel) {
  subject.kernel = kernel;
  return subject;
}

/// Mean over the frames of the median over their repeats; frames after the time limit have none.
double typical_ms(std::vector<std::vector<double>> launches) {
  std::erase_if(launches, [](const std::vector<double>& repeats) { return repeats.empty(); });
  double sum = 0;
  for (std::vector<double>& repeats : launches) {
    std::ranges::sort(repeats);
    sum += percentile(repeats, 0.5);
  }
  return sum / static_cast<double>(launches.size());
}

void measure_candidates(const BenchmarkSpec& spec, const LoadedScene& scene, const Subject& subject,
                        std::vector<Candidate>& candidates, DeviceQueue& queue,
                        const std::function<void()>& before_launch) {
  DeviceQueue::Hold hold = queue.hold();
  std::vector<std::unique_ptr<SpacedFrames>> techniques;
  std::vector<Technique*> pointers;
  for (const Candidate& candidate : candidates) {
    techniques.push_back(std::make_unique<SpacedFrames>(hold, spec, scene, with_knobs(subject, candidate.kernel)));
    pointers.push_back(techniques.back().get());
  }
  const MeasurePlan plan{.frames = std::min(kFrames, spec.frames),
                         .warmup = 1,
                         .repeats = kRepeats,
                         .time_limit_s = std::min(kRoundSeconds, spec.time_limit_s)};
  Measurements measured = measure(pointers, plan, [&](u64, u64) { before_launch(); });
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].frame_ms = typical_ms(std::move(measured.ms[i]));
}

WrongRays check_rays(const BenchmarkSpec& spec, const Subject& subject, Comparison& comparison) {
  ErrorFigures figures;
  for (const u32 frame : compared_frames(spec)) comparison.add_rays(subject, frame, figures);
  return {figures.wrong_rays(), figures.checked_rays()};
}

/// Counts and names the knobs by which the candidate differs from strict.
void compare_with(const Candidate& strict, const TraversalInfo& traversal, Candidate& candidate) {
  for (const Option& option : traversal.options) {
    const double value = candidate.kernel.find(option.name)->second;
    if (value == strict.kernel.find(option.name)->second) continue;
    candidate.name += candidate.changed++ > 0 ? ", " : "";
    candidate.name += option.choices.at(static_cast<std::size_t>(value));
  }
  if (candidate.changed == 0) candidate.name = strict.name;
}

Candidate base_candidate(const OptionValues& base, const GivenOptions& given) {
  const bool is_fixed =
      std::ranges::any_of(tier_knobs(), [&](const TierKnob& knob) { return given.contains(std::string(knob.option)); });
  return {base, is_fixed ? "as given" : "strict"};
}

/// The knobs that are left out of the combinations, as a sentence; empty when there are none.
std::string slower_text(std::span<const Candidate> singles) {
  std::string names;
  for (const Candidate& single : singles.subspan(1)) {
    if (single.frame_ms >= singles.front().frame_ms) names += (names.empty() ? "" : ", ") + single.name;
  }
  return names.empty() ? "" : " Not faster by themselves: " + names + ".";
}

}  // namespace

std::vector<Candidate> single_changes(const TraversalInfo& traversal, const StructureForm& form,
                                      const OptionValues& base, const GivenOptions& given) {
  std::vector<Candidate> candidates = {base_candidate(base, given)};
  for (const TierKnob& knob : tier_knobs()) {
    const auto option = std::ranges::find(traversal.options, knob.option, &Option::name);
    const std::string name(knob.option);
    if (!knob.is_tried || option == traversal.options.end() || given.contains(name)) continue;
    for (u32 value = 0; value < option->choices.size(); ++value) {
      if (value == base.at(name)) continue;
      Candidate candidate{base, ""};
      candidate.kernel[name] = value;
      if (!why_unfit(form, candidate.kernel).empty()) continue;
      compare_with(candidates.front(), traversal, candidate);
      candidates.push_back(std::move(candidate));
    }
  }
  return candidates;
}

std::vector<Candidate> combinations(const TraversalInfo& traversal, std::span<const Candidate> singles) {
  const Candidate& strict = singles.front();
  std::vector<OptionValues> sets = {strict.kernel};
  for (const TierKnob& knob : tier_knobs()) {
    const std::string name(knob.option);
    const std::size_t others = sets.size();
    for (const Candidate& single : singles) {
      const auto value = single.kernel.find(name);
      if (value == single.kernel.end() || value->second == strict.kernel.at(name)) continue;
      if (single.frame_ms >= strict.frame_ms) continue;
      for (std::size_t i = 0; i < others; ++i) {
        OptionValues set = sets[i];
        set[name] = value->second;
        sets.push_back(std::move(set));
      }
    }
  }
  std::vector<Candidate> candidates;
  for (OptionValues& set : sets) {
    candidates.push_back({std::move(set), ""});
    compare_with(strict, traversal, candidates.back());
  }
  return candidates;
}

void choose_knobs(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<Subject> subjects,
                  const std::vector<KindInfo>& kinds, Comparison& comparison, DeviceQueue& queue,
                  const std::function<void(std::size_t subject)>& before_launch) {
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    Subject& subject = subjects[i];
    const KindInfo& kind = kind_named(kinds, subject.technique.structure, "");
    const TraversalInfo& traversal = traversal_named(kind, subject.technique.traversal, "");
    if (subject.technique.tier != Tier::automatic || !has_tiers(traversal)) continue;
    const auto measured = [&](std::vector<Candidate> candidates) {
      measure_candidates(spec, scene, subject, candidates, queue, [&] { before_launch(i); });
      return candidates;
    };
    const StructureForm form = subject.structure.structure->form();
    const std::vector<Candidate> singles =
        measured(single_changes(traversal, form, subject.kernel, subject.technique.kernel));
    std::vector<Candidate> together = combinations(traversal, singles);
    together = together.size() > 1 ? measured(std::move(together)) : std::vector{singles.front()};
    subject.choice = choose(std::move(together), [&](const Candidate& candidate) {
      before_launch(i);
      return check_rays(spec, with_knobs(subject, candidate.kernel), comparison);
    });
    subject.choice->reason += slower_text(singles);
    set_kernel(subject, kind, traversal, subject.choice->candidates[subject.choice->chosen].kernel);
  }
}

}  // namespace raywalk
