// A measurement of accuracy: the hard cases, and speed against error over the knobs on one scene.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/accuracy/cases/hard_cases.h"
#include "server/accuracy/sweep/combinations.h"
#include "server/accuracy/sweep/errors.h"
#include "server/accuracy/sweep/spec.h"
#include "server/bench/benchmark.h"

namespace raywalk::accuracy {

/// One combination on one class of rays.
struct SweepRow {
  Combination combination;
  RayKind kind = RayKind::primary;
  u64 rays = 0;
  Statistics launch_ms;           // of the whole list
  double worst_over_median = 0;   // launch
  double bytes_per_triangle = 0;  // of the structure
  std::optional<double> steps_per_ray;
  u64 judged = 0;  // rays, evenly spaced over the list
  SweepErrors errors;

  /// At the median of the launches, and at the ends of its interval.
  double mrays_per_s(double ms) const { return ms > 0 ? static_cast<double>(rays) / (ms * 1e3) : 0; }
};

/// What rays cost that are invalid, against valid ones that meet nothing.
struct InvalidCost {
  Combination combination;
  double ratio = 0;
};

struct AccuracyResult {
  std::string created_at;  // RFC 3339 UTC
  Machine machine;
  ScenePtr scene;  // null: hard cases alone
  std::vector<StructureRecord> structures;
  std::vector<SweepRow> rows;
  std::vector<InvalidCost> invalid_costs;
  std::vector<CaseOutcome> cases;
  bool reached_time_limit = false;
  std::vector<std::string> notes;
};

/// `spec` is checked. `report` is called at least once a launch, and before each hard case of each technique; what it
/// throws ends the run. At the time limit what is left is left out, and the result says so.
AccuracyResult run_accuracy(const AccuracySpec& spec, const Workplace& place,
                            const std::function<void(const BenchmarkProgress&)>& report);

}  // namespace raywalk::accuracy
