// Warm-up, then passes over the frames with the techniques interleaved.
#include "server/bench/measure.h"

#include <chrono>

namespace raywalk {

Measurements measure(std::span<Technique* const> techniques, const MeasurePlan& plan,
                     const std::function<void(u64 done, u64 total)>& before_launch) {
  const u64 total = techniques.size() * plan.total_frames();
  u64 done = 0;
  const auto perform = [&](Technique& technique, u32 launch) {
    before_launch(done, total);
    done += plan.per_launch;
    return technique.measure(plan.first_frame(launch), plan.per_launch) / plan.per_launch;
  };
  for (Technique* technique : techniques) {
    for (u32 i = 0; i < plan.warmup; ++i) perform(*technique, i % plan.launches());
  }

  Measurements out;
  out.ms.assign(techniques.size(), std::vector<std::vector<double>>(plan.launches()));
  const auto begin = std::chrono::steady_clock::now();
  for (u32 repeat = 0; repeat < plan.repeats; ++repeat) {
    for (u32 launch = 0; launch < plan.launches(); ++launch) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
      if (elapsed.count() >= plan.time_limit_s && repeat + launch > 0) {
        out.reached_time_limit = true;
        return out;
      }
      for (std::size_t i = 0; i < techniques.size(); ++i) {
        out.ms[i][launch].push_back(perform(*techniques[i], launch));
      }
    }
  }
  return out;
}

}  // namespace raywalk
