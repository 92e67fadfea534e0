// Device memory into ordinary host memory, at the speed of the bus.
#pragma once
#include "server/device/cuda/launch.h"
#include "server/device/cuda/memory.h"

namespace raywalk::cuda {

/// While one piece is copied from the device into page-locked memory, the piece before it is copied on from there.
class Readback {
 public:
  /// Throws CudaError.
  Readback(const std::shared_ptr<const Context>& context, const Stream& stream);
  /// After all that was queued; `to` is complete afterwards. Throws CudaError.
  void copy(CUdeviceptr from, void* to, u64 size_bytes) const;

 private:
  const Stream& stream_;
  PinnedBuffer pieces_;
  std::array<Event, 2> ready_;
};

}  // namespace raywalk::cuda
