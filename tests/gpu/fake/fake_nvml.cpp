// Sensors without a device, all of which tell something.
//   FAKE_NVML_FAIL   the one that fails: device, power, temperature or throttle (default none)
#include <cstdlib>
#include <string_view>

#include "server/device/cuda/nvml_api.h"

using namespace raywalk;
using namespace raywalk::cuda;

namespace {

nvmlReturn_t unless_failing(std::string_view name) {
  const char* failing = std::getenv("FAKE_NVML_FAIL");
  return failing != nullptr && name == failing ? nvmlReturn_t{3} : NVML_SUCCESS;
}

}  // namespace

extern "C" {

nvmlReturn_t nvmlInit_v2() {
  return NVML_SUCCESS;
}

nvmlReturn_t nvmlShutdown() {
  return NVML_SUCCESS;
}

const char* nvmlErrorString(nvmlReturn_t) {
  return "Not Supported";
}

nvmlReturn_t nvmlDeviceGetHandleByPciBusId_v2(const char*, nvmlDevice_t* device) {
  static char the_device;
  *device = reinterpret_cast<nvmlDevice_t>(&the_device);
  return unless_failing("device");
}

nvmlReturn_t nvmlDeviceGetClockInfo(nvmlDevice_t, nvmlClockType_t type, unsigned* mhz) {
  *mhz = type == NVML_CLOCK_SM ? 1980 : 2619;
  return NVML_SUCCESS;
}

nvmlReturn_t nvmlDeviceGetPowerUsage(nvmlDevice_t, unsigned* milliwatts) {
  *milliwatts = 402'500;
  return unless_failing("power");
}

nvmlReturn_t nvmlDeviceGetEnforcedPowerLimit(nvmlDevice_t, unsigned* milliwatts) {
  *milliwatts = 700'000;
  return NVML_SUCCESS;
}

nvmlReturn_t nvmlDeviceGetTemperature(nvmlDevice_t, nvmlTemperatureSensors_t, unsigned* celsius) {
  *celsius = 45;
  return unless_failing("temperature");
}

nvmlReturn_t nvmlDeviceGetCurrentClocksThrottleReasons(nvmlDevice_t, u64* reasons) {
  *reasons = kThrottlePowerCap | kThrottleThermal;
  return unless_failing("throttle");
}

}  // extern "C"
