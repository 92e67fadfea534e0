// Load, build, measure, validate.
#include "server/bench/benchmark.h"

#include <algorithm>
#include <set>
#include <string>

#include "server/bench/measure.h"
#include "server/bench/subject.h"
#include "server/bench/validation.h"
#include "server/system/refusal.h"
#include "server/system/time_text.h"

namespace raywalk {
namespace {

// Tests every triangle: correct, and too slow to be asked for unawares.
constexpr std::string_view kOracle = "brute";

// Parts of the whole for the progress bar.
constexpr double kBuildPart = 0.1, kMeasurePart = 0.7;

void check_technique(const TechniqueSpec& technique, const BenchmarkSpec& spec, const std::vector<KindInfo>& kinds,
                     const std::string& pointer) {
  const KindInfo& kind = kind_named(kinds, technique.structure, pointer + "/structure");
  const TraversalInfo& traversal = traversal_named(kind, technique.traversal, pointer + "/traversal");
  complete_options(kind, technique.options, pointer + "/options");
  if (traversal.baseline && std::find(spec.modes.begin(), spec.modes.end(), BenchMode::trace) == spec.modes.end()) {
    throw Refusal(Refusal::Why::invalid, "baseline_only_traces",
                  kind.name + "/" + traversal.name + " is a baseline: it is measured in mode trace alone.")
        .at(pointer + "/traversal");
  }
}

std::vector<Subject> make_subjects(const BenchmarkSpec& spec, const ScenePtr& scene, const Workplace& place,
                                   const std::function<void(const BenchmarkProgress&)>& report) {
  std::vector<Subject> subjects;
  double done = 0;
  for (const TechniqueSpec& technique : spec.techniques) {
    const double fraction = kBuildPart * done++ / static_cast<double>(spec.techniques.size());
    report({"building " + technique.structure, false, fraction, 0, 0});
    const StructureRecord structure = place.structures.build_and_wait(scene, technique.structure, technique.options);
    const KindInfo& kind = kind_named(place.structures.kinds(), technique.structure, "");
    const bool baseline = traversal_named(kind, technique.traversal, "").baseline;
    for (const BenchMode mode : spec.modes) {
      if (!baseline || mode == BenchMode::trace) subjects.push_back({technique, mode, structure, baseline});
    }
  }
  return subjects;
}

std::vector<Subject> make_references(std::span<const Subject> subjects, const ScenePtr& scene, const Workplace& place,
                                     const std::function<void(const BenchmarkProgress&)>& report) {
  std::vector<Subject> references;
  std::set<std::string> seen;
  for (const Subject& subject : subjects) {
    const TechniqueSpec technique = reference_of(subject.technique);
    if (!seen.insert(technique.structure).second) continue;
    report({"building " + technique.structure + " for reference", false, kBuildPart, 0, 0});
    references.push_back({technique, BenchMode::primary,
                          place.structures.build_and_wait(scene, technique.structure, technique.options)});
  }
  return references;
}

/// Holds the device for as long as it measures.
Measurements measure_alone(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                           DeviceQueue& queue, const std::function<void(const BenchmarkProgress&)>& report) {
  report({"waiting for the device", false, kBuildPart, 0, 0});
  DeviceQueue::Hold hold = queue.hold();
  std::vector<DeviceTechnique> techniques;
  std::vector<Technique*> pointers;
  techniques.reserve(subjects.size());
  for (const Subject& subject : subjects) {
    techniques.emplace_back(hold, spec, scene, subject);
    pointers.push_back(&techniques.back());
  }
  const MeasurePlan plan{spec.frames, spec.warmup, spec.repeats, spec.time_limit_s};
  const std::string measuring = subjects.size() == 1
                                    ? "measuring " + subjects[0].name()
                                    : "measuring " + std::to_string(subjects.size()) + " combinations in turns";
  return measure(pointers, plan, [&](u64 done, u64 total) {
    const double part = static_cast<double>(done) / static_cast<double>(total);
    const bool warming = done < subjects.size() * plan.warmup;
    const std::string stage = warming ? "warming up " + subjects[done / plan.warmup].name() : measuring;
    report({stage, false, kBuildPart + kMeasurePart * part, done, total});
  });
}

ResultRow make_row(const Subject& subject, std::vector<std::vector<double>> ms, Validation validation) {
  ResultRow row;
  row.structure = subject.technique.structure;
  row.traversal = subject.technique.traversal;
  row.structure_id = subject.structure.id;
  row.mode = subject.mode;
  std::erase_if(ms, [](const std::vector<double>& repeats) { return repeats.empty(); });  // past the time limit
  row.frame_ms = summarise(ms);
  for (std::vector<double>& repeats : ms) {
    std::sort(repeats.begin(), repeats.end());
    row.frame_times_ms.push_back(percentile(repeats, 0.5));
  }
  const Counts& counts = validation.counts;
  const auto rays = static_cast<double>(counts.rays);
  row.rays_per_frame = rays / static_cast<double>(std::max<u64>(validation.error.frames, 1));
  if (row.frame_ms.mean > 0) row.mrays_per_s = row.rays_per_frame / (row.frame_ms.mean * 1e3);
  if (validation.counts_work && counts.rays > 0) {
    row.steps_per_ray = static_cast<double>(counts.steps) / rays;
    row.tests_per_ray = static_cast<double>(counts.tests) / rays;
  }
  row.error = std::move(validation.error);
  return row;
}

std::vector<std::string> notes_on(const BenchmarkSpec& spec, const BenchmarkResult& result) {
  std::vector<std::string> notes;
  if (result.reached_time_limit) notes.push_back("Measuring stopped at the time limit; frames after it are missing.");
  if (spec.repeats == 1)
    notes.push_back("With one repeat the spread over repeats is unknown and nothing is called unstable.");
  for (const std::string& warning : result.scene->warnings) notes.push_back("Scene: " + warning);
  const auto unstable =
      std::count_if(result.rows.begin(), result.rows.end(), [](const ResultRow& row) { return row.frame_ms.unstable; });
  if (unstable > 0) {
    notes.push_back(std::to_string(unstable) +
                    " rows are unstable: their times vary by more than 3.5 % between repeats.");
  }
  return notes;
}

}  // namespace

BenchmarkSpec checked(BenchmarkSpec spec, const Workplace& place) {
  const std::vector<KindInfo>& kinds = place.structures.kinds();
  place.scenes.find(spec.scene, "/spec/scene");
  if (spec.techniques.empty()) {
    for (const KindInfo& kind : kinds) {
      if (kind.name == kOracle) continue;
      for (const TraversalInfo& traversal : kind.traversals) {
        if (!traversal.baseline) spec.techniques.push_back({kind.name, traversal.name, {}});
      }
    }
  }
  for (std::size_t i = 0; i < spec.techniques.size(); ++i) {
    check_technique(spec.techniques[i], spec, kinds, "/spec/techniques/" + std::to_string(i));
  }
  return spec;
}

BenchmarkResult run_benchmark(const BenchmarkSpec& spec, const Workplace& place,
                              const std::function<void(const BenchmarkProgress&)>& report) {
  report({"loading " + spec.scene, false, 0, 0, 0});
  BenchmarkResult result;
  result.scene = place.scenes.resident_or_load(spec.scene);
  const std::vector<Subject> subjects = make_subjects(spec, result.scene, place, report);
  const std::vector<Subject> references = make_references(subjects, result.scene, place, report);

  Measurements measured = measure_alone(spec, *result.scene, subjects, place.queue, report);
  const u64 frames = u64{subjects.size()} * (spec.warmup + u64{spec.frames} * spec.repeats);
  std::vector<Validation> validations =
      validate(spec, *result.scene, subjects, references, place.queue, [&](double fraction) {
        const double before = kBuildPart + kMeasurePart;
        report({"comparing with the reference", true, before + (1 - before) * fraction, frames, frames});
      });

  result.created_at = now_text();
  result.machine = place.machine;
  result.reached_time_limit = measured.reached_time_limit;
  std::set<std::string> listed;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    result.rows.push_back(make_row(subjects[i], std::move(measured.ms[i]), std::move(validations[i])));
    if (listed.insert(subjects[i].structure.id).second) result.structures.push_back(subjects[i].structure);
  }
  result.notes = notes_on(spec, result);
  return result;
}

}  // namespace raywalk
