// Memory of the device, and host memory that the device copies to at full speed.
#pragma once
#include <atomic>

#include "server/device/cuda/handle.h"

namespace raywalk::cuda {

/// Device memory; `allocated` counts its bytes while it lives.
class DeviceBuffer {
 public:
  DeviceBuffer() = default;
  ~DeviceBuffer() { reset(); }
  DeviceBuffer(DeviceBuffer&& other) noexcept = default;
  DeviceBuffer& operator=(DeviceBuffer&& other) noexcept;

  /// Empty when the device has not that much. Throws CudaError for any other failure. `allocated` outlives it.
  static DeviceBuffer try_allocate(const std::shared_ptr<const Context>& context, u64 size_bytes,
                                   std::atomic<u64>& allocated);

  explicit operator bool() const { return static_cast<bool>(memory_); }
  CUdeviceptr address() const { return memory_.get(); }
  u64 size_bytes() const { return memory_ ? size_bytes_ : 0; }
  void reset();

 private:
  Handle<CUdeviceptr, &DriverApi::cuMemFree> memory_;
  u64 size_bytes_ = 0;
  std::atomic<u64>* allocated_ = nullptr;
};

/// Page-locked host memory.
class PinnedBuffer {
 public:
  /// Throws CudaError.
  PinnedBuffer(const std::shared_ptr<const Context>& context, u64 size_bytes);
  u8* data() const { return static_cast<u8*>(memory_.get()); }

 private:
  Handle<void*, &DriverApi::cuMemFreeHost> memory_;
};

}  // namespace raywalk::cuda
