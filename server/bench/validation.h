// After measuring: error figures against the reference, and work counts.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "server/bench/comparison.h"

namespace raywalk {

/// What validation adds to a row.
struct Validation {
  ErrorFigures error;
  Counts counts{};          // over the compared frames
  bool counts_work = true;  // false: rays alone are known
};

/// Compares the compared frames of every subject, and counts their work on the device of `queue`. `before_frame` gets
/// the fraction done.
std::vector<Validation> validate(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                                 Comparison& comparison, DeviceQueue& queue,
                                 const std::function<void(double fraction)>& before_frame);

}  // namespace raywalk
