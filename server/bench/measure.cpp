// Warm-up, then passes over the frames with the techniques interleaved.
#include "server/bench/measure.h"

#include <chrono>

namespace raywalk {

Measurements measure(std::span<Technique* const> techniques, const MeasurePlan& plan,
                     const std::function<void(u64 done, u64 total)>& before_frame) {
  const u64 total = u64{techniques.size()} * (plan.warmup + u64{plan.frames} * plan.repeats);
  u64 done = 0;
  for (Technique* technique : techniques) {
    for (u32 i = 0; i < plan.warmup; ++i) {
      before_frame(done++, total);
      technique->measure(i % plan.frames);
    }
  }

  Measurements out;
  out.ms.assign(techniques.size(), std::vector<std::vector<double>>(plan.frames));
  const auto begin = std::chrono::steady_clock::now();
  for (u32 repeat = 0; repeat < plan.repeats; ++repeat) {
    for (u32 frame = 0; frame < plan.frames; ++frame) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
      if (elapsed.count() >= plan.time_limit_s && repeat + frame > 0) {
        out.reached_time_limit = true;
        return out;
      }
      for (std::size_t i = 0; i < techniques.size(); ++i) {
        before_frame(done++, total);
        out.ms[i][frame].push_back(techniques[i]->measure(frame));
      }
    }
  }
  return out;
}

}  // namespace raywalk
