// Load, build, measure, validate.
#include "server/bench/benchmark.h"

#include <algorithm>
#include <set>
#include <string>

#include "server/bench/choose_knobs.h"
#include "server/bench/session.h"
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
  const OptionValues options = complete_options(kind, technique.options, pointer + "/options");
  const OptionValues kernel = kernel_options(kind, traversal, technique.tier, technique.kernel, pointer + "/kernel");
  check_form(form_of(options), kernel, pointer + "/kernel/intersector");
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
    for (const BenchMode mode : spec.modes) {
      Subject subject = make_subject(technique, mode, structure, place.structures.kinds());
      if (!subject.baseline || mode == BenchMode::trace) subjects.push_back(std::move(subject));
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
    Structures& structures = place.reference_structures;
    references.push_back(make_subject(technique, BenchMode::primary,
                                      structures.build_and_wait(scene, technique.structure, technique.options),
                                      structures.kinds()));
  }
  return references;
}

/// Statistics and the median of each launch; a launch after the time limit has no times.
Statistics summarise_launches(std::vector<std::vector<double>> ms, std::vector<double>& medians) {
  std::erase_if(ms, [](const std::vector<double>& repeats) { return repeats.empty(); });
  for (std::vector<double>& repeats : ms) {
    std::sort(repeats.begin(), repeats.end());
    medians.push_back(percentile(repeats, 0.5));
  }
  return summarise(ms);
}

double mrays_per_s(double rays_per_frame, const Statistics& frame_ms) {
  return frame_ms.mean > 0 ? rays_per_frame / (frame_ms.mean * 1e3) : 0;
}

/// Row `index` of the result.
ResultRow make_row(const Subject& subject, const Session& session, std::size_t index, Validation validation) {
  ResultRow row;
  row.structure = subject.technique.structure;
  row.traversal = subject.technique.traversal;
  row.structure_id = subject.structure.id;
  row.mode = subject.mode;
  row.frame_ms = summarise_launches(session.single.ms[index], row.frame_times_ms);
  row.kernel = session.kernels[index];
  row.kernel_options = subject.kernel;
  row.changed_options = subject.changed_options;

  const Counts& counts = validation.counts;
  const auto rays = static_cast<double>(counts.rays);
  row.rays_per_frame = rays / static_cast<double>(std::max<u64>(validation.error.frames, 1));
  row.mrays_per_s = mrays_per_s(row.rays_per_frame, row.frame_ms);
  if (session.batched && !session.batched->ms[index].empty()) {
    std::vector<double> medians;
    const Statistics frame_ms = summarise_launches(session.batched->ms[index], medians);
    row.throughput = {session.frames_per_launch, frame_ms, mrays_per_s(row.rays_per_frame, frame_ms)};
  }
  if (validation.counts_work && counts.rays > 0) {
    row.steps_per_ray = static_cast<double>(counts.steps) / rays;
    row.tests_per_ray = static_cast<double>(counts.tests) / rays;
  }
  row.error = std::move(validation.error);
  row.gate = decide_gate(subject.terms, row.error, row.frame_ms.samples);
  row.gate.choice = subject.choice;
  return row;
}

std::vector<std::string> notes_on(const BenchmarkSpec& spec, const Session& session, const BenchmarkResult& result) {
  std::vector<std::string> notes = session.notes;
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
  const auto open = std::ranges::count_if(result.rows, [](const ResultRow& row) { return row.gate.is_open; });
  if (open > 0) {
    notes.push_back(std::to_string(open) + " of " + std::to_string(result.rows.size()) +
                    " rows are open: they are not right enough for their tier, and their times do not count.");
  }
  return notes;
}

}  // namespace

const char* mode_name(BenchMode mode) {
  switch (mode) {
    case BenchMode::trace:
      return "trace";
    case BenchMode::primary:
      return "primary";
    case BenchMode::shadow:
      return "shadow";
    case BenchMode::whitted:
      return "whitted";
  }
  return "primary";
}

BenchmarkSpec checked(BenchmarkSpec spec, const Scenes& scenes, const std::vector<KindInfo>& kinds) {
  scenes.find(spec.scene, "/spec/scene");
  if (spec.techniques.empty()) {
    for (const KindInfo& kind : kinds) {
      if (kind.name == kOracle) continue;
      for (const TraversalInfo& traversal : kind.traversals) {
        if (!traversal.baseline) spec.techniques.push_back({kind.name, traversal.name});
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
  std::vector<Subject> subjects = make_subjects(spec, result.scene, place, report);
  const std::vector<Subject> references = make_references(subjects, result.scene, place, report);

  Comparison comparison(spec, *result.scene, references, place.queue, place.reference_queue);
  choose_knobs(spec, *result.scene, subjects, place.structures.kinds(), comparison, place.queue, [&](std::size_t i) {
    report({"choosing the knobs of " + subjects[i].name, false, kBuildPart, 0, 0});
  });

  const Session session =
      measure_alone(spec, *result.scene, subjects, place.queue, [&](const SessionProgress& progress) {
        const double part = static_cast<double>(progress.frames_done) / static_cast<double>(progress.frames_total);
        report({progress.stage, false, kBuildPart + kMeasurePart * part, progress.frames_done, progress.frames_total});
      });
  std::vector<Validation> validations =
      validate(spec, *result.scene, subjects, comparison, place.queue, [&](double fraction) {
        const double before = kBuildPart + kMeasurePart;
        report(
            {"comparing with the reference", true, before + (1 - before) * fraction, session.frames, session.frames});
      });

  result.created_at = now_text();
  result.machine = place.machine;
  result.reached_time_limit = session.reached_time_limit();
  result.telemetry = session.telemetry;
  std::set<std::string> listed;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    result.rows.push_back(make_row(subjects[i], session, i, std::move(validations[i])));
    if (listed.insert(subjects[i].structure.id).second) result.structures.push_back(subjects[i].structure);
  }
  result.notes = notes_on(spec, session, result);
  return result;
}

}  // namespace raywalk
