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

/// The value that `call` gives, 0 where the GPU has no such sensor.
template <class Call, class... Arguments>
unsigned sensor(Call call, Arguments... arguments) {
  unsigned value = 0;
  return call(arguments..., &value) == NVML_SUCCESS ? value : 0;
}

}  // namespace

Sensors::Sensors(const std::string& pci_bus_id) : nvml_(open_nvml().value) {
  if (nvml_ && nvml_->nvmlDeviceGetHandleByPciBusId(pci_bus_id.c_str(), &device_) != NVML_SUCCESS) device_ = nullptr;
}

std::optional<Telemetry> Sensors::read() const {
  if (device_ == nullptr) return std::nullopt;
  Telemetry now;
  now.core_clock_mhz = sensor(nvml_->nvmlDeviceGetClockInfo, device_, NVML_CLOCK_SM);
  now.memory_clock_mhz = sensor(nvml_->nvmlDeviceGetClockInfo, device_, NVML_CLOCK_MEM);
  now.power_w = sensor(nvml_->nvmlDeviceGetPowerUsage, device_) / 1000.0;
  now.power_limit_w = sensor(nvml_->nvmlDeviceGetEnforcedPowerLimit, device_) / 1000.0;
  now.temperature_c = sensor(nvml_->nvmlDeviceGetTemperature, device_, NVML_TEMPERATURE_GPU);
  u64 bits = 0;
  if (nvml_->nvmlDeviceGetCurrentClocksThrottleReasons(device_, &bits) != NVML_SUCCESS) bits = 0;
  for (const Reason& reason : kReasons)
    if ((bits & reason.bit) != 0) now.throttle_reasons.emplace_back(reason.name);
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
