// auto takes a GPU if there is one, and after a crash only the kind of device that there was: jobs wait for it.
#include "server/open_devices.h"

#include <spdlog/spdlog.h>

namespace raywalk {

Devices open_devices(const Flags& flags, const std::string& crashed_device) {
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
    if (flags.device == "cuda") throw NoDevice("--device cuda cannot be had. " + opened.why_not);
    if (crashed_device == "cuda") {
      throw NoDevice("The daemon that crashed here used a GPU; --device cpu goes on without it. " + opened.why_not);
    }
    devices.warnings.push_back("No GPU is used, the CPU renders. " + opened.why_not);
    spdlog::warn("{}", devices.warnings.back());
    devices.no_cuda = std::move(opened.why_not);
  }
  devices.rendering = open_cpu_device(flags.threads);
  return devices;
}

}  // namespace raywalk
