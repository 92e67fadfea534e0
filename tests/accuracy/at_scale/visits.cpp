// Visits of nodes with padded boxes against plain ones.
#include <algorithm>
#include <cstdio>

#include "server/accuracy/sweep/ray_lists.h"
#include "server/device/knobs.h"
#include "server/system/stopwatch.h"
#include "tests/accuracy/at_scale/run.h"

namespace raywalk::at_scale {
namespace {

using accuracy::RayKind;

constexpr double kMostRatio = 1.01;
constexpr u64 kRays = 1'000'000, kLeastRays = 10'000;  // of a list

struct Walk {
  std::string structure, traversal;
};

/// Those of the device that ask boxes; grid and kd-tree have no box test to choose.
std::vector<Walk> walks_of(const Device& device) {
  std::vector<Walk> walks;
  for (const KindInfo& kind : device.kinds())
    for (const TraversalInfo& traversal : kind.traversals)
      if (!traversal.baseline && std::ranges::find(traversal.options, "slab", &Option::name) != traversal.options.end())
        walks.push_back({kind.name, traversal.name});
  return walks;
}

double slab_named(std::string_view name) {
  return static_cast<double>(std::ranges::find(slab_rows(), name, &KnobRow::name) - slab_rows().begin());
}

u64 visits(Run& run, const RayJob& job) {
  u64 steps = 0;
  for (const Counts& of_ray : run.queue.run([&](Device& device) { return device.count_rays(job); }))
    steps += of_ray.steps;
  return steps;
}

void compare(Run& run, const std::string& what, RayJob job) {
  const Stopwatch watch;
  const u64 padded = visits(run, job);
  job.kernel["slab"] = slab_named("plain");
  const u64 plain = visits(run, job);
  const double ratio = static_cast<double>(padded) / static_cast<double>(std::max<u64>(1, plain));
  char note[96];
  std::snprintf(note, sizeof note, "%llu visits, plain %llu, ratio %.5f", padded, plain, ratio);
  run.table.add({"visits", what, job.rays.size(), ratio <= kMostRatio ? 0u : 1u, watch.ms() * 1e-3, note});
}

void ask_scene(Run& run, const ScenePtr& scene) {
  const u64 rays = std::max(kLeastRays, static_cast<u64>(static_cast<double>(kRays) * run.settings.share));
  for (const Walk& walk : walks_of(run.queue.device())) {
    const std::shared_ptr<const Structure> structure =
        run.queue.run([&](Device& device) { return device.build(scene->blob, walk.structure, {}); });
    const auto closest = [&](const std::vector<Ray>& list) {
      return run.queue.run([&](Device& device) { return device.closest({structure, walk.traversal, list}); });
    };
    accuracy::RayMaker maker(*scene, rays, run.settings.seed, closest);
    for (const RayKind kind : {RayKind::primary, RayKind::diffuse}) {
      const accuracy::RayList list = maker.make(kind, std::string(spawn_rows().front().name));
      const std::string what =
          scene->info.name + " " + accuracy::name_of(kind) + " " + walk.structure + "/" + walk.traversal;
      compare(run, what, {structure, walk.traversal, list.rays});
    }
  }
}

Scenes catalogue(const Settings& settings) {
  return {settings.scenes_dir, settings.data_dir, [](const std::string&, const ScenePtr&) {}};
}

}  // namespace

void check_scenes(const Settings& settings) {
  const Scenes scenes = catalogue(settings);
  for (const std::string& name : settings.scenes) scenes.find(name);
}

void ask_visits(Run& run) {
  Scenes scenes = catalogue(run.settings);
  for (const std::string& name : run.settings.scenes) {
    ask_scene(run, scenes.resident_or_load(name));
    scenes.evict(name);
  }
}

}  // namespace raywalk::at_scale
