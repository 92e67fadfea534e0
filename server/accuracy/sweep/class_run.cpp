// Lists by spawn offset; one judge and one brute force for each.
#include "server/accuracy/sweep/class_run.h"

#include <map>

#include "server/accuracy/sweep/brute.h"
#include "server/accuracy/sweep/measuring.h"

namespace raywalk::accuracy {
namespace {

constexpr u64 kMostCounted = 16'384;  // rays whose steps are counted
constexpr double kMeasurePart = 0.5;  // of the progress

/// A list with everything that is known of its rays.
struct Inspected {
  Inspected(RayList its_list, const Run& run, const ScenePtr& scene, const Reference& reference)
      : list(std::move(its_list)),
        judge(reference.oracle, reference.scene, reference.fans, list),
        brute(run, scene, list) {}
  RayList list;
  Judge judge;
  BruteForce brute;
};
using Lists = std::map<std::string, std::unique_ptr<Inspected>>;  // by spawn offset

const std::string& key_of(RayKind kind, const std::string& spawn) {
  static const std::string any;
  return is_spawned(kind) ? spawn : any;
}

std::optional<double> steps_of(const Run& run, const Combination& one, const RayList& list) {
  if (list.query() == RayQuery::any || !run.place.queue.device().can_count(one.structure_kind)) return std::nullopt;
  std::vector<Ray> rays;
  const u64 stride = (list.rays.size() + kMostCounted - 1) / kMostCounted;
  for (u64 i = 0; i < list.rays.size(); i += stride) rays.push_back(list.rays[i]);
  const std::vector<Counts> counts =
      run.place.queue.run([&](Device& device) { return device.count_rays(one.job(rays)); });
  u64 steps = 0;
  for (const Counts& of_ray : counts) steps += of_ray.steps;
  return static_cast<double>(steps) / static_cast<double>(rays.size());
}

Answers answers_of(const Run& run, const Combination& one, const RayList& list) {
  const bool aimed = list.kind == RayKind::edge || list.kind == RayKind::vertex;
  return run.place.queue.run([&](Device& device) {
    Answers answers;
    answers.hits = device.closest(one.job(list.rays));
    if (list.query() == RayQuery::any) answers.occluded = device.occluded(one.job(list.rays));
    if (aimed) answers.beyond = device.closest(one.job(continued_rays(list.rays, answers.hits)));
    return answers;
  });
}

double bytes_per_triangle(const Combination& one) {
  const double bytes = static_cast<double>(one.structure.structure->stats().size_bytes);
  return bytes / static_cast<double>(std::max<u64>(1, one.structure.triangles));
}

}  // namespace

u32 launches_of(const Run& run) {
  if (run.on_gpu()) return run.spec.quick ? 15 : 30;
  return run.spec.quick ? 5 : 9;
}

void run_class(Run& run, RayKind kind, const std::vector<Combination>& all, RayMaker& maker, const Reference& reference,
               AccuracyResult& out,
               const std::function<void(const std::string& stage, double fraction, bool judging)>& report) {
  const std::string of_class = std::string(name_of(kind)) + " rays";
  report("making " + of_class, 0, false);
  const std::vector<std::size_t> places = combinations_for(kind, all);
  Lists lists;
  std::vector<TimedList> timed;
  for (const std::size_t place : places) {
    std::unique_ptr<Inspected>& made = lists[key_of(kind, all[place].spawn())];
    if (!made) made = std::make_unique<Inspected>(maker.make(kind, all[place].spawn()), run, out.scene, reference);
    timed.push_back({&all[place], made->list.rays, made->list.query()});
  }
  if (timed.empty() || timed.front().rays.empty()) {
    out.notes.push_back("The scene has no " + of_class + ": nothing is hit, or there is no lamp.");
    return;
  }
  const std::string measuring = "measuring " + of_class + " in turns";
  const Measurements times = measure_lists(timed, launches_of(run), std::max(0.0, run.seconds_left()), run.place.queue,
                                           [&](double done) { report(measuring, kMeasurePart * done, false); });
  out.reached_time_limit |= times.reached_time_limit;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Combination& one = all[places[i]];
    Inspected& with = *lists.at(key_of(kind, one.spawn()));
    const double part = (1 - kMeasurePart) / static_cast<double>(places.size());
    const double before = kMeasurePart + part * static_cast<double>(i);
    const std::string judging = "judging " + of_class + " of " + one.name();
    report(judging, before, true);
    SweepRow& row = out.rows.emplace_back();
    row.combination = one;
    row.kind = kind;
    row.rays = with.list.rays.size();
    row.launch_ms = summarise(times.ms[i]);
    const std::vector<double>& ms = times.ms[i].front();
    row.worst_over_median = *std::ranges::max_element(ms) / std::max(row.launch_ms.median, 1e-9);
    row.bytes_per_triangle = bytes_per_triangle(one);
    row.steps_per_ray = steps_of(run, one, with.list);
    row.judged = with.judge.judged();
    const Answers answers = answers_of(run, one, with.list);
    row.errors = with.judge.errors_of(answers, [&](double done) { report(judging, before + part * done, true); });
    with.brute.compare(one, answers.hits, row.errors);
  }
}

}  // namespace raywalk::accuracy
