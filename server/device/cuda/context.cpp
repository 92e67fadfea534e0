// Retains and releases the primary context; asks the driver for the facts of a GPU.
#include "server/device/cuda/context.h"

#include <array>
#include <cstdio>

namespace raywalk::cuda {
namespace {

u32 attribute(const DriverApi& driver, CUdevice device, CUdevice_attribute which) {
  int value = 0;
  RW_CUDA(driver, cuDeviceGetAttribute, &value, which, device);
  return static_cast<u32>(value);
}

GpuFacts facts_of(const DriverApi& driver, CUdevice device) {
  const auto get = [&](CUdevice_attribute which) { return attribute(driver, device, which); };
  GpuFacts facts;
  std::array<char, 256> name{};
  RW_CUDA(driver, cuDeviceGetName, name.data(), static_cast<int>(name.size()), device);
  facts.name = name.data();
  facts.capability =
      10 * get(CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR) + get(CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR);
  facts.architecture = "sm_" + std::to_string(facts.capability);
  std::array<char, 40> bus_id{};
  std::snprintf(bus_id.data(), bus_id.size(), "%08x:%02x:%02x.0", get(CU_DEVICE_ATTRIBUTE_PCI_DOMAIN_ID),
                get(CU_DEVICE_ATTRIBUTE_PCI_BUS_ID), get(CU_DEVICE_ATTRIBUTE_PCI_DEVICE_ID));
  facts.pci_bus_id = bus_id.data();
  facts.multiprocessors = get(CU_DEVICE_ATTRIBUTE_MULTIPROCESSOR_COUNT);
  facts.threads_per_multiprocessor = get(CU_DEVICE_ATTRIBUTE_MAX_THREADS_PER_MULTIPROCESSOR);
  size_t bytes = 0;
  RW_CUDA(driver, cuDeviceTotalMem, &bytes, device);
  facts.memory_bytes = bytes;
  return facts;
}

}  // namespace

Context::Context(std::shared_ptr<const DriverApi> driver, int ordinal) : driver_(std::move(driver)) {
  RW_CUDA(*driver_, cuDeviceGet, &device_, ordinal);
  facts_ = facts_of(*driver_, device_);
  RW_CUDA(*driver_, cuDevicePrimaryCtxRetain, &context_, device_);
  if (!try_make_current()) {
    driver_->cuDevicePrimaryCtxRelease(device_);
    throw CudaError(CUDA_ERROR_INVALID_DEVICE, "the context of " + facts_.name + " cannot be made current");
  }
}

Context::~Context() {
  driver_->cuDevicePrimaryCtxRelease(device_);
}

void Context::make_current() const {
  RW_CUDA(*driver_, cuCtxSetCurrent, context_);
}

Context::Memory Context::memory() const {
  make_current();
  size_t free_bytes = 0, total_bytes = 0;
  RW_CUDA(*driver_, cuMemGetInfo, &free_bytes, &total_bytes);
  return {free_bytes, total_bytes};
}

}  // namespace raywalk::cuda
