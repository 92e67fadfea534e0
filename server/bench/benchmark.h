// A benchmark: what is asked, what comes out, and the run between them.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/bench/gate.h"
#include "server/bench/statistics.h"
#include "server/bench/telemetry.h"
#include "server/catalog/scenes.h"
#include "server/catalog/structures.h"
#include "server/catalog/tiers.h"
#include "server/system/machine.h"

namespace raywalk {

enum class BenchMode { trace, primary, shadow, whitted };
const char* mode_name(BenchMode mode);

struct TechniqueSpec {
  std::string structure;
  std::string traversal;
  GivenOptions options = {};
  GivenOptions kernel = {};  // of the traversal; what is given overrides the tier's knobs
  Tier tier = Tier::strict;

  bool operator==(const TechniqueSpec&) const = default;
};

struct BenchmarkSpec {
  std::string scene;
  std::vector<TechniqueSpec> techniques;  // empty: all of the device but baselines and brute
  std::vector<BenchMode> modes;
  u32 depth = 2;
  u32 width = 1024, height = 1024;  // pixels
  u32 frames = 400;
  u32 warmup = 5;
  u32 repeats = 1;
  u32 batch = 16;  // frames of a launch for throughput; less than 2: it is not measured
  u32 error_frames = 4;
  double time_limit_s = 3600;

  bool operator==(const BenchmarkSpec&) const = default;
};

/// Several frames in one launch.
struct Throughput {
  u32 frames_per_launch = 0;
  Statistics frame_ms;  // of a launch, over its frames
  double mrays_per_s = 0;
};

struct ResultRow {
  std::string structure, traversal, structure_id;
  BenchMode mode = BenchMode::primary;
  Statistics frame_ms;
  double mrays_per_s = 0;
  double rays_per_frame = 0;
  std::optional<double> steps_per_ray, tests_per_ray;
  std::vector<double> frame_times_ms;  // median of each measured frame
  OptionValues kernel_options;         // complete
  std::string changed_options;         // of builder and kernel, that are not the default: " name=value" each
  std::optional<KernelFigures> kernel;
  std::optional<Throughput> throughput;
  ErrorFigures error;
  Gate gate;
};

struct BenchmarkResult {
  std::string created_at;  // RFC 3339 UTC
  Machine machine;
  ScenePtr scene;
  std::vector<StructureRecord> structures;
  std::vector<ResultRow> rows;
  std::optional<TelemetrySummary> telemetry;  // while measuring
  bool reached_time_limit = false;
  std::vector<std::string> notes;
};

/// What a benchmark works with. The references of errors run on a CPU: another engine where the measured one is a GPU,
/// else the same.
struct Workplace {
  Scenes& scenes;
  Structures& structures;
  DeviceQueue& queue;
  Structures& reference_structures;
  DeviceQueue& reference_queue;
  const Machine& machine;
};

/// What the run tells while it goes on.
struct BenchmarkProgress {
  std::string stage;  // for people; the same from its begin to its end
  bool validating = false;
  double fraction = 0;  // of the whole
  u64 frames_done = 0, frames_total = 0;
};

/// Fills in the default techniques. Throws Refusal, with pointers under /spec, for techniques that do not exist, bad
/// options, and baselines where mode trace is not among the modes; they have no rows in others.
BenchmarkSpec checked(BenchmarkSpec spec, const Scenes& scenes, const std::vector<KindInfo>& kinds);

/// Loads, builds, chooses the knobs of tier auto, warms up and measures alone on the device, then validates against the
/// reference. `report` is called
/// before each of these and at least once a frame; what it throws ends the run.
BenchmarkResult run_benchmark(const BenchmarkSpec& spec, const Workplace& place,
                              const std::function<void(const BenchmarkProgress&)>& report);

}  // namespace raywalk
