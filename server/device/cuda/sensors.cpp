// Reads clocks, power, temperature and what holds the clocks back.
#include "server/device/cuda/sensors.h"

#include <array>

namespace raywalk::cuda {
namespace {

struct Reason {
  u64 bit;
  const char* name;
};
constexpr std::array kReasons = {
    Reason{kThrottleIdle, "idle"},
    Reason{kThrottleClocksSetting, "clocks setting"},
    Reason{kThrottlePowerCap, "power cap"},
    Reason{kThrottleHardware, "hardware slowdown"},
    Reason{kThrottleSyncBoost, "sync boost"},
    Reason{kThrottleThermal, "thermal"},
    Reason{kThrottleHardwareThermal, "hardware thermal"},
    Reason{kThrottlePowerBrake, "power brake"},
    Reason{kThrottleDisplayClocks, "display clocks"},
};

/// What one reading collects; `complete` turns false with the first sensor that gives nothing.
struct Reading {
  bool complete = true;

  template <class Call, class... Arguments>
  unsigned of(Call call, Arguments... arguments) {
    unsigned value = 0;
    complete = call(arguments..., &value) == NVML_SUCCESS && complete;
    return value;
  }
};

std::vector<std::string> throttle_reasons(const NvmlApi& nvml, nvmlDevice_t device) {
  u64 bits = 0;
  if (nvml.nvmlDeviceGetCurrentClocksThrottleReasons(device, &bits) != NVML_SUCCESS) return {"unknown"};
  std::vector<std::string> names;
  for (const Reason& reason : kReasons)
    if ((bits & reason.bit) != 0) names.emplace_back(reason.name);
  return names;
}

}  // namespace

Sensors::Sensors(const std::string& pci_bus_id) {
  const Found<NvmlApi> nvml = open_nvml();
  nvml_ = nvml.value;
  why_not_ = nvml.why_not;
  if (!nvml_) return;
  const nvmlReturn_t result = nvml_->nvmlDeviceGetHandleByPciBusId(pci_bus_id.c_str(), &device_);
  if (result == NVML_SUCCESS) {
    if (!read()) why_not_ = "Not all sensors of the GPU can be read.";
    return;
  }
  device_ = nullptr;
  why_not_ = "NVML does not know the GPU " + pci_bus_id + ": " + nvml_->nvmlErrorString(result) + ".";
}

std::optional<Telemetry> Sensors::read() const {
  if (device_ == nullptr) return std::nullopt;
  Reading sensor;
  Telemetry now;
  now.core_clock_mhz = sensor.of(nvml_->nvmlDeviceGetClockInfo, device_, NVML_CLOCK_SM);
  now.memory_clock_mhz = sensor.of(nvml_->nvmlDeviceGetClockInfo, device_, NVML_CLOCK_MEM);
  now.power_w = sensor.of(nvml_->nvmlDeviceGetPowerUsage, device_) / 1000.0;
  now.power_limit_w = sensor.of(nvml_->nvmlDeviceGetEnforcedPowerLimit, device_) / 1000.0;
  now.temperature_c = sensor.of(nvml_->nvmlDeviceGetTemperature, device_, NVML_TEMPERATURE_GPU);
  now.throttle_reasons = throttle_reasons(*nvml_, device_);
  if (!sensor.complete) return std::nullopt;
  return now;
}

std::string Sensors::driver_version() const {
  if (!nvml_) return {};
  nvmlReturn_t (*get)(char* version, unsigned capacity_bytes) = nullptr;
  std::string missing;
  bind(*nvml_->library, "nvmlSystemGetDriverVersion", get, missing);
  std::array<char, 96> version{};
  if (get == nullptr || get(version.data(), static_cast<unsigned>(version.size())) != NVML_SUCCESS) return {};
  return version.data();
}

}  // namespace raywalk::cuda
