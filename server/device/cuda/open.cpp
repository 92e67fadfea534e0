// Puts a CUDA device together, or says what is missing for one.
#include <algorithm>

#include "server/device/cuda/cuda_device.h"
#include "server/device/cuda/nvrtc_api.h"

namespace raywalk {
namespace {

using namespace cuda;

/// Of compute capability, as GpuFacts has it: the first whose warps add up in one instruction.
constexpr u32 kLeastCapability = 80;

/// "8.0" of 80.
std::string capability_text(u32 capability) {
  return std::to_string(capability / 10) + '.' + std::to_string(capability % 10);
}

DeviceOrReason none(std::string why_not) {
  return {nullptr, std::move(why_not)};
}

DeviceOrReason open(const std::shared_ptr<const DriverApi>& driver, const CudaConfig& config) {
  int gpus = 0;
  RW_CUDA(*driver, cuDeviceGetCount, &gpus);
  if (gpus == 0) return none("The NVIDIA driver shows no GPU.");
  const auto context = std::make_shared<const Context>(driver, 0);
  const GpuFacts& gpu = context->facts();
  if (gpu.capability < kLeastCapability) {
    return none("The GPU " + gpu.name + " has compute capability " + capability_text(gpu.capability) + ", and " +
                capability_text(kLeastCapability) + " or higher is needed.");
  }
  const Found<NvrtcApi> nvrtc = open_nvrtc(driver->version);
  if (!nvrtc) return none(nvrtc.why_not);

  const std::vector<std::string> architectures = nvrtc.value->architectures();
  if (std::find(architectures.begin(), architectures.end(), gpu.architecture) == architectures.end()) {
    return none("The GPU " + gpu.name + " has the architecture " + gpu.architecture + ", and NVRTC " +
                nvrtc.value->version() + " (" + nvrtc.value->library->path() + ") compiles for " +
                joined(architectures) + " only.");
  }
  const auto compiler = std::make_shared<const Compiler>(nvrtc.value, gpu.architecture, config.cache_dir);
  std::map<std::string, std::string> details{{"nvrtc", nvrtc.value->version()}};
  if (config.memory_limit_bytes != 0) details["memory_limit_mib"] = std::to_string(config.memory_limit_bytes >> 20);
  return {std::make_unique<CudaDevice>(context, compiler, std::move(details), config), {}};
}

}  // namespace

DeviceOrReason open_cuda_device(const CudaConfig& config) {
  const Found<DriverApi> driver = open_driver();
  if (!driver) return none(driver.why_not);
  try {
    return open(driver.value, config);
  } catch (const CudaError& error) {
    return none(std::string("The GPU cannot be used: ") + error.what() + ".");
  } catch (const CompileError& error) {
    return none(std::string("Kernels cannot be compiled: ") + error.what());
  }
}

}  // namespace raywalk
