// The hard cases, one after the other, so that a time limit leaves whole ones.
#include <algorithm>

#include "server/accuracy/sweep/run.h"

namespace raywalk::accuracy {
namespace {

constexpr double kQuickRays = 0.1;  // of the full number

/// Each technique with each intersector, the rest strict; in a quick run with the strict one alone.
std::vector<Technique> asked_techniques(const Run& run) {
  const std::vector<KindInfo>& kinds = run.place.structures.kinds();
  std::vector<Technique> all;
  for (const SweepTechnique& technique : run.spec.techniques) {
    const KindInfo& kind = kind_named(kinds, technique.structure, "");
    const TraversalInfo& traversal = traversal_named(kind, technique.traversal, "");
    const auto found = std::ranges::find(traversal.options, "intersector", &Option::name);
    std::vector<GivenOptions> sets = {{}};
    if (found != traversal.options.end() && !run.spec.quick) {
      for (std::size_t i = 1; i < found->choices.size(); ++i) {
        sets.push_back({{"intersector", std::string(found->choices[i])}});
      }
    }
    for (const GivenOptions& set : sets) {
      const OptionValues kernel = complete_options(kind, traversal, set, "");
      const GivenOptions builder = builder_options(kind, technique.options, kernel);
      all.push_back({kind.name, traversal.name, complete_options(kind, builder, ""), kernel});
    }
  }
  return all;
}

}  // namespace

void run_cases(Run& run, AccuracyResult& out) {
  SuiteSpec suite{.techniques = asked_techniques(run),
                  .numbers = {},
                  .rays = run.spec.quick ? kQuickRays : 1.0,
                  .seed = run.spec.seed};
  const auto on_device = [&](const std::function<void(Device&)>& work) {
    run.place.queue.run([&](Device& device) { work(device); });
  };
  const std::vector<CaseTitle>& titles = case_titles();
  for (std::size_t i = 0; i < titles.size(); ++i) {
    if (run.seconds_left() <= 0) {
      out.reached_time_limit = true;
      out.notes.push_back("The time limit came before hard case " + std::to_string(titles[i].number) + ".");
      return;
    }
    suite.numbers = {titles[i].number};
    for (CaseOutcome& outcome : run_hard_cases(on_device, suite, [&](double fraction, const std::string&what) {
           const double done = (static_cast<double>(i) + fraction) / static_cast<double>(titles.size());
           run.report("hard case " + std::to_string(titles[i].number) + ": " + what, done);
         })) {
      out.cases.push_back(std::move(outcome));
    }
  }
}

}  // namespace raywalk::accuracy
