// auto takes a GPU if there is one.
#include "server/open_devices.h"

#include <spdlog/spdlog.h>

namespace raywalk {

Devices open_devices(const Flags& flags) {
  Devices devices;
  if (flags.device != "cpu") {
    CudaConfig config;
    config.cache_dir = flags.kernel_cache_dir;
    config.memory_limit_bytes = u64{flags.device_memory_mib} << 20;
    config.fault_after = flags.fault_after;
    config.threads = flags.threads;
    DeviceOrReason opened = open_cuda_device(config);
    if (opened.device) {
      devices.rendering = std::move(opened.device);
      devices.reference = open_cpu_device(flags.threads);
      return devices;
    }
    if (flags.device == "cuda") throw NoDevice("There is no GPU for --device cuda. " + opened.why_not);
    spdlog::info("device=cpu: {}", opened.why_not);
    devices.warnings.push_back("No GPU is used, the CPU renders. " + opened.why_not);
    devices.no_cuda = std::move(opened.why_not);
  }
  devices.rendering = open_cpu_device(flags.threads);
  return devices;
}

}  // namespace raywalk
