// NVML, the sensors of NVIDIA devices, opened at run time: one list of its calls, and a struct filled in from it.
#pragma once
#include <memory>

#include "kernels/platform.h"
#include "server/device/cuda/library.h"

namespace raywalk::cuda {

using nvmlDevice_t = struct nvmlDevice_st*;
enum nvmlReturn_t : int { NVML_SUCCESS = 0 };
enum nvmlClockType_t : int { NVML_CLOCK_SM = 1, NVML_CLOCK_MEM = 2 };
enum nvmlTemperatureSensors_t : int { NVML_TEMPERATURE_GPU = 0 };

/// Bits of nvmlDeviceGetCurrentClocksThrottleReasons.
enum ThrottleReason : u64 {
  kThrottleIdle = 1u << 0,
  kThrottleClocksSetting = 1u << 1,
  kThrottlePowerCap = 1u << 2,
  kThrottleHardware = 1u << 3,
  kThrottleSyncBoost = 1u << 4,
  kThrottleThermal = 1u << 5,
  kThrottleHardwareThermal = 1u << 6,
  kThrottlePowerBrake = 1u << 7,
  kThrottleDisplayClocks = 1u << 8,
};

}  // namespace raywalk::cuda

// X(call, symbol in the library, parameters...); every call returns an nvmlReturn_t.
#define RW_NVML_CALLS(X)                                                                                           \
  X(nvmlInit, "nvmlInit_v2", void)                                                                                 \
  X(nvmlShutdown, "nvmlShutdown", void)                                                                            \
  X(nvmlDeviceGetHandleByPciBusId, "nvmlDeviceGetHandleByPciBusId_v2", const char* bus_id, nvmlDevice_t* device)   \
  X(nvmlDeviceGetClockInfo, "nvmlDeviceGetClockInfo", nvmlDevice_t device, nvmlClockType_t type, unsigned* mhz)    \
  X(nvmlDeviceGetPowerUsage, "nvmlDeviceGetPowerUsage", nvmlDevice_t device, unsigned* milliwatts)                 \
  X(nvmlDeviceGetEnforcedPowerLimit, "nvmlDeviceGetEnforcedPowerLimit", nvmlDevice_t device, unsigned* milliwatts) \
  X(nvmlDeviceGetTemperature, "nvmlDeviceGetTemperature", nvmlDevice_t device, nvmlTemperatureSensors_t sensor,    \
    unsigned* celsius)                                                                                             \
  X(nvmlDeviceGetCurrentClocksThrottleReasons, "nvmlDeviceGetCurrentClocksThrottleReasons", nvmlDevice_t device,   \
    u64* reasons)

namespace raywalk::cuda {

/// NVML is shut down when the last pointer to it goes.
struct NvmlApi {
#define RW_NVML_MEMBER(call, symbol, ...) nvmlReturn_t (*call)(__VA_ARGS__) = nullptr;
  RW_NVML_CALLS(RW_NVML_MEMBER)
#undef RW_NVML_MEMBER
  const char* (*nvmlErrorString)(nvmlReturn_t result) = nullptr;

  std::shared_ptr<const Library> library;
};

/// Opens libnvidia-ml.so.1, or the library that the environment variable RAYWALK_LIBNVML names, and starts it.
Found<NvmlApi> open_nvml();

}  // namespace raywalk::cuda
