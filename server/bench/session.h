// All measurements of a benchmark, with the device held: single frames, then several in one launch.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "server/bench/subject.h"

namespace raywalk {

/// What the session tells while it goes on.
struct SessionProgress {
  std::string stage;
  u64 frames_done = 0, frames_total = 0;
};

struct Session {
  Measurements single;
  u32 frames_per_launch = 0;  // of `batched`
  /// Nothing where frames are taken one at a time; no launches of a subject that has no room for two.
  std::optional<Measurements> batched;
  std::vector<std::optional<KernelFigures>> kernels;  // of each subject
  std::optional<TelemetrySummary> telemetry;
  u64 frames = 0;                  // of all measurements, warm-up included
  std::vector<std::string> notes;  // for people, such as why throughput is missing

  bool reached_time_limit() const { return single.reached_time_limit || (batched && batched->reached_time_limit); }
};

/// Frames of one launch when throughput is measured; less than 2: it is not.
u32 frames_per_launch(const BenchmarkSpec& spec, const Device& device);

/// Waits for the device and holds it while it measures. `report` is called before each launch; what it throws ends
/// the session. Both parts together keep the time limit, but for one turn of each.
Session measure_alone(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                      DeviceQueue& queue, const std::function<void(const SessionProgress&)>& report);

}  // namespace raywalk
