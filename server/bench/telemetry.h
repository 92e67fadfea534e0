// The device's sensors, read while it measures.
#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "server/device/device.h"

namespace raywalk {

struct SensorRange {
  double min = 0, median = 0, max = 0;
};

/// Of several readings; units as in Telemetry.
struct TelemetrySummary {
  SensorRange core_clock_mhz, memory_clock_mhz, power_w, temperature_c;
  double power_limit_w = 0;                   // the last
  std::vector<std::string> throttle_reasons;  // all that were seen, sorted
};

/// Nothing of no readings.
std::optional<TelemetrySummary> summarise_readings(std::span<const Telemetry> readings);

/// Reads the sensors on a thread of its own, from its making to `stop`; a device without sensors is asked once.
class TelemetrySampler {
 public:
  explicit TelemetrySampler(const Device& device, std::chrono::milliseconds interval = std::chrono::milliseconds{100});
  ~TelemetrySampler() { stop(); }
  TelemetrySampler(const TelemetrySampler&) = delete;
  TelemetrySampler& operator=(const TelemetrySampler&) = delete;

  /// Reads once more. The readings are complete after the first call.
  const std::vector<Telemetry>& stop();

 private:
  bool read();
  void loop(std::chrono::milliseconds interval);

  const Device& device_;
  std::vector<Telemetry> readings_;  // of the thread's alone while it runs
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace raywalk
