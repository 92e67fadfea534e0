// Hard cases with far more rays than a test has: every worker asks them with random numbers of its own.
#include <algorithm>

#include "tests/accuracy/at_scale/run.h"
#include "tests/accuracy/at_scale/workers.h"

namespace raywalk::at_scale {
namespace {

using accuracy::CaseOutcome;

constexpr double kAimedRays = 1e6, kSpawnedRays = 1e7;  // of one technique at SuiteSpec::rays = 1
// Some are left out: of the few meshes that rounding has folded, and at places that the primary ray misses.
constexpr double kAimedSpare = 1.08, kSpawnedSpare = 1.01;

Row row_of(const std::string& part, const accuracy::Technique& technique) {
  return {.part = part, .technique = name_of(technique)};
}

/// A row for each technique; the seconds are those of the slowest worker, while all share the device.
void ask_cases(Run& run, const std::string& part, const std::vector<u32>& numbers, double rays) {
  const accuracy::SuiteSpec spec{run.techniques, numbers, rays * run.settings.share / run.settings.threads};
  const auto outcomes = run_workers(run.settings.threads, [&](u32 worker) {
    accuracy::SuiteSpec own = spec;
    own.seed = run.seed_of(worker);
    const auto on_device = [&](const std::function<void(Device&)>& work) { run.queue.run(work); };
    return run_hard_cases(on_device, own, [](double, const std::string&) {});
  });
  const std::size_t techniques = run.techniques.size();
  std::vector<Row> rows;
  for (const accuracy::Technique& technique : run.techniques) rows.push_back(row_of(part, technique));
  for (std::size_t i = 0; i < outcomes.front().size(); ++i) {  // case after case
    Row& row = rows[i % techniques];
    double ms = 0;
    for (const std::vector<CaseOutcome>& of_worker : outcomes) {
      const CaseOutcome& outcome = of_worker[i];
      row.rays += outcome.rays;
      row.failures += outcome.failures + outcome.nans;
      if (row.first_failure.empty()) row.first_failure = outcome.first_failure;
      if (row.note.empty()) row.note = outcome.why_not;
      ms = std::max(ms, outcome.ms);
    }
    row.seconds += ms * 1e-3;
  }
  for (const Row& row : rows) run.table.add(row);
}

}  // namespace

void ask_edges(Run& run) {
  ask_cases(run, "edges", {1}, kAimedSpare * 1e8 / kAimedRays);
}

void ask_vertices(Run& run) {
  ask_cases(run, "vertices", {2}, kAimedSpare * 1e8 / kAimedRays);
}

void ask_spawned(Run& run) {
  const double techniques = static_cast<double>(run.techniques.size());
  ask_cases(run, "spawned", {35, 36, 38}, kSpawnedSpare * 1e9 / kSpawnedRays / techniques);
}

}  // namespace raywalk::at_scale
