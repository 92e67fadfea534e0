// Allocates and frees device memory and page-locked memory.
#include "server/device/cuda/memory.h"

namespace raywalk::cuda {

DeviceBuffer& DeviceBuffer::operator=(DeviceBuffer&& other) noexcept {
  if (this == &other) return *this;
  reset();
  memory_ = std::move(other.memory_);
  size_bytes_ = other.size_bytes_;
  allocated_ = other.allocated_;
  return *this;
}

DeviceBuffer DeviceBuffer::try_allocate(const std::shared_ptr<const Context>& context, u64 size_bytes,
                                        std::atomic<u64>& allocated) {
  const DriverApi& driver = context->driver();
  CUdeviceptr address = 0;
  const CUresult result = driver.cuMemAlloc(&address, size_bytes);
  DeviceBuffer buffer;
  if (result == CUDA_ERROR_OUT_OF_MEMORY) return buffer;
  check(driver, result, "cuMemAlloc");
  buffer.memory_ = {context, address};
  buffer.size_bytes_ = size_bytes;
  buffer.allocated_ = &allocated;
  allocated += size_bytes;
  return buffer;
}

void DeviceBuffer::reset() {
  if (!memory_) return;
  memory_.reset();
  *allocated_ -= size_bytes_;
}

PinnedBuffer::PinnedBuffer(const std::shared_ptr<const Context>& context, u64 size_bytes) {
  void* memory = nullptr;
  RW_CUDA(context->driver(), cuMemHostAlloc, &memory, size_bytes, 0);
  memory_ = {context, memory};
}

}  // namespace raywalk::cuda
