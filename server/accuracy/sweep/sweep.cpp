// Build, then class after class, then what invalid rays cost.
#include "server/accuracy/sweep/sweep.h"

#include <algorithm>
#include <set>

#include "server/accuracy/sweep/class_run.h"
#include "server/accuracy/sweep/measuring.h"
#include "server/accuracy/sweep/run.h"
#include "server/system/time_text.h"

namespace raywalk::accuracy {
namespace {

// Parts of the whole for the progress bar.
constexpr double kCasesPart = 0.4, kBuildPart = 0.05, kClassesPart = 0.9;

u64 rays_of(const Run& run) {
  if (run.spec.rays > 0) return run.spec.rays;
  const u64 rays = run.on_gpu() ? 1'000'000 : 100'000;
  return run.spec.quick ? rays / 10 : rays;
}

/// Builds what a sweep needs and lists it in the result.
std::vector<Combination> build_all(Run& run, AccuracyResult& out) {
  std::set<std::string> listed;
  const Build build = [&](const std::string& kind, const GivenOptions& options) {
    run.report("building " + kind, kBuildPart / 2);
    StructureRecord record = run.place.structures.build_and_wait(out.scene, kind, options);
    if (listed.insert(record.id).second) out.structures.push_back(record);
    return record;
  };
  return combinations(run.spec, run.place.structures.kinds(), build);
}

/// Hits for the origins of spawned rays: the same on every device.
std::vector<Hit> reference_hits(const Workplace& place, const ScenePtr& scene, const std::vector<Ray>& rays) {
  const StructureRecord structure = place.reference_structures.build_and_wait(scene, "bvh", {});
  const RayJob job{structure.structure, "while-while", rays};
  return place.reference_queue.run([&](Device& device) { return device.closest(job); });
}

void measure_invalid(Run& run, const std::vector<Combination>& all, const RayMaker& maker, AccuracyResult& out) {
  const std::vector<Ray> misses = maker.misses(), invalid = made_invalid(misses);
  if (misses.empty()) return;
  std::vector<TimedList> lists;
  for (const Combination& one : all) {
    if (!one.changed.empty()) continue;
    lists.push_back({&one, misses, RayQuery::closest});
    lists.push_back({&one, invalid, RayQuery::closest});
  }
  const double from = kBuildPart + kClassesPart;
  const Measurements times =
      measure_lists(lists, launches_of(run), std::max(0.0, run.seconds_left()), run.place.queue,
                    [&](double done) { run.report("measuring invalid rays", from + (1 - from) * done); });
  for (std::size_t i = 0; i < lists.size(); i += 2) {
    const double valid_ms = summarise(times.ms[i]).median, invalid_ms = summarise(times.ms[i + 1]).median;
    out.invalid_costs.push_back({*lists[i].combination, invalid_ms / std::max(valid_ms, 1e-9)});
  }
}

}  // namespace

void run_sweep(Run& run, AccuracyResult& out) {
  run.report("loading " + run.spec.scene, 0);
  out.scene = run.place.scenes.resident_or_load(run.spec.scene);
  const std::vector<Combination> all = build_all(run, out);
  run.report("preparing the oracle", kBuildPart);
  const Reference reference(SceneView{out.scene->blob->data()});
  RayMaker maker(*out.scene, rays_of(run), run.spec.seed,
                 [&](const std::vector<Ray>& rays) { return reference_hits(run.place, out.scene, rays); });
  const double part = kClassesPart / static_cast<double>(run.spec.classes.size());
  double before = kBuildPart;
  for (const RayKind kind : run.spec.classes) {
    if (run.seconds_left() <= 0) {
      out.reached_time_limit = true;
      out.notes.push_back(std::string("The time limit came before the ") + name_of(kind) + " rays.");
      continue;
    }
    run_class(run, kind, all, maker, reference, out, [&](const std::string& stage, double fraction, bool judging) {
      run.report(stage, before + part * fraction, judging);
    });
    before += part;
  }
  if (run.seconds_left() > 0) measure_invalid(run, all, maker, out);
}

AccuracyResult run_accuracy(const AccuracySpec& spec, const Workplace& place,
                            const std::function<void(const BenchmarkProgress&)>& report) {
  Run run(spec, place, report);
  AccuracyResult out;
  const bool has_scene = !spec.scene.empty();
  const double cases_end = !spec.hard_cases ? 0.0 : has_scene ? kCasesPart : 1.0;
  run.enter(0, cases_end);
  if (spec.hard_cases) run_cases(run, out);
  run.enter(cases_end, 1);
  if (has_scene) run_sweep(run, out);
  out.created_at = now_text();
  out.machine = place.machine;
  return out;
}

}  // namespace raywalk::accuracy
