// Readings and their ranges.
#include "server/bench/telemetry.h"

#include <algorithm>
#include <set>

#include "server/bench/statistics.h"

namespace raywalk {
namespace {

template <class Value>
SensorRange range_of(std::span<const Telemetry> readings, Value value) {
  std::vector<double> values;
  for (const Telemetry& reading : readings) values.push_back(value(reading));
  std::sort(values.begin(), values.end());
  return {values.front(), percentile(values, 0.5), values.back()};
}

}  // namespace

std::optional<TelemetrySummary> summarise_readings(std::span<const Telemetry> readings) {
  if (readings.empty()) return std::nullopt;
  TelemetrySummary out;
  out.core_clock_mhz = range_of(readings, [](const Telemetry& t) { return t.core_clock_mhz; });
  out.memory_clock_mhz = range_of(readings, [](const Telemetry& t) { return t.memory_clock_mhz; });
  out.power_w = range_of(readings, [](const Telemetry& t) { return t.power_w; });
  out.temperature_c = range_of(readings, [](const Telemetry& t) { return t.temperature_c; });
  out.power_limit_w = readings.back().power_limit_w;
  std::set<std::string> reasons;
  for (const Telemetry& reading : readings) {
    reasons.insert(reading.throttle_reasons.begin(), reading.throttle_reasons.end());
  }
  out.throttle_reasons.assign(reasons.begin(), reasons.end());
  return out;
}

TelemetrySampler::TelemetrySampler(const Device& device, std::chrono::milliseconds interval) : device_(device) {
  if (read()) thread_ = std::thread([this, interval] { loop(interval); });
}

bool TelemetrySampler::read() {
  std::optional<Telemetry> reading = device_.telemetry();
  if (!reading) return false;
  readings_.push_back(std::move(*reading));
  return true;
}

void TelemetrySampler::loop(std::chrono::milliseconds interval) {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, interval, [this] { return stopping_; })) read();
}

const std::vector<Telemetry>& TelemetrySampler::stop() {
  if (!thread_.joinable()) return readings_;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_one();
  thread_.join();
  read();
  return readings_;
}

}  // namespace raywalk
