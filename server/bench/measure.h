// The measuring loop. It does not know what it measures.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

class Technique {
 public:
  virtual ~Technique() = default;
  /// Performs frame `frame` once and returns its time in ms.
  virtual double measure(u32 frame) = 0;
};

struct MeasurePlan {
  u32 frames = 1;
  u32 warmup = 0;   // frames of each technique that do not count
  u32 repeats = 1;  // passes over all frames
  double time_limit_s = 3600;
};

struct Measurements {
  /// ms[technique][frame][repeat]; every technique has the same frames and repeats.
  std::vector<std::vector<std::vector<double>>> ms;
  bool reached_time_limit = false;
};

/// Techniques take turns frame by frame, so that a slow drift of the machine meets all alike. `before_frame` gets
/// the frames done (of all techniques) and their total; what it throws ends the measurement. At the time limit the
/// techniques finish the frame they are at, so that all have the same samples, and at least one.
Measurements measure(std::span<Technique* const> techniques, const MeasurePlan& plan,
                     const std::function<void(u64 done, u64 total)>& before_frame);

}  // namespace raywalk
