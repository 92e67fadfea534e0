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
  /// Performs the frames [first, first + frames) once, together, and returns the time of all in ms.
  virtual double measure(u32 first, u32 frames) = 0;
};

struct MeasurePlan {
  u32 frames = 1;
  u32 per_launch = 1;  // frames performed together, at most `frames`
  u32 warmup = 0;      // launches of each technique that do not count
  u32 repeats = 1;     // passes over all frames
  double time_limit_s = 3600;

  /// Launches of a pass. All are full: the last begins earlier where the frames do not divide evenly.
  u32 launches() const { return (frames + per_launch - 1) / per_launch; }
  /// First frame of launch `i`.
  u32 first_frame(u32 i) const { return i + 1 < launches() ? i * per_launch : frames - per_launch; }
  /// Frames performed by one technique, those of the warm-up and repeated ones included.
  u64 total_frames() const { return u64{per_launch} * (warmup + u64{launches()} * repeats); }
};

struct Measurements {
  /// Times of a frame: ms[technique][launch][repeat]; every technique has the same launches and repeats.
  std::vector<std::vector<std::vector<double>>> ms;
  bool reached_time_limit = false;
};

/// Techniques take turns launch by launch, so that a slow drift of the machine meets all alike. `before_launch` gets
/// the frames done (of all techniques) and their total; what it throws ends the measurement. At the time limit the
/// techniques finish the launch they are at, so that all have the same samples, and at least one.
Measurements measure(std::span<Technique* const> techniques, const MeasurePlan& plan,
                     const std::function<void(u64 done, u64 total)>& before_launch);

}  // namespace raywalk
