// After measuring: error figures against the reference, and work counts.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "server/bench/subject.h"

namespace raywalk {

/// What validation adds to a row.
struct Validation {
  ErrorFigures error;
  Counts counts{};          // over the compared frames
  bool counts_work = true;  // false: rays alone are known
};

/// The technique that `subject` is compared with: watertight Embree, and bvh/while-while for Embree itself.
TechniqueSpec reference_of(const TechniqueSpec& technique);

/// Compares `error_frames` evenly spaced frames of every subject. `references` has a structure for each reference
/// that is needed, for the device of `reference_queue`. `before_frame` gets the fraction done.
std::vector<Validation> validate(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                                 std::span<const Subject> references, DeviceQueue& queue, DeviceQueue& reference_queue,
                                 const std::function<void(double fraction)>& before_frame);

}  // namespace raywalk
