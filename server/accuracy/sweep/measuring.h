// Times of lists of rays, combinations in turns, with the device held.
#pragma once
#include "server/accuracy/sweep/combinations.h"
#include "server/bench/measure.h"
#include "server/device/device_queue.h"

namespace raywalk::accuracy {

/// One combination with one list.
struct TimedList {
  const Combination* combination;
  std::span<const Ray> rays;
  RayQuery query;
};

/// ms[list][0][launch]: each list is launched `launches` times after one that does not count, until `time_limit_s`, but
/// at least once. `report` gets the fraction done; what it throws ends the measurement.
Measurements measure_lists(std::span<const TimedList> lists, u32 launches, double time_limit_s, DeviceQueue& queue,
                           const std::function<void(double fraction)>& report);

}  // namespace raywalk::accuracy
