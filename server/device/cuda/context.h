// A GPU and its primary context.
#pragma once
#include <memory>
#include <string>

#include "server/device/cuda/error.h"

namespace raywalk::cuda {

/// What is known of a GPU before anything runs on it.
struct GpuFacts {
  std::string name;          // such as "NVIDIA H100 80GB HBM3"
  std::string architecture;  // such as "sm_90"
  u32 capability = 0;        // 10 * major + minor
  std::string pci_bus_id;    // such as "00000000:17:00.0", as NVML takes it
  u32 multiprocessors = 0;
  u32 threads_per_multiprocessor = 0;  // resident at most
  u64 memory_bytes = 0;
};

class Context {
 public:
  struct Memory {
    u64 free_bytes = 0, total_bytes = 0;
  };

  /// The GPU `ordinal` of those that the driver shows; its context is current on this thread afterwards. Throws
  /// CudaError.
  Context(std::shared_ptr<const DriverApi> driver, int ordinal);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const DriverApi& driver() const { return *driver_; }
  const GpuFacts& facts() const { return facts_; }

  /// On the calling thread. Throws CudaError.
  void make_current() const;
  /// False when that failed.
  bool try_make_current() const { return driver_->cuCtxSetCurrent(context_) == CUDA_SUCCESS; }
  /// Of the whole card, other processes included. From any thread. Throws CudaError.
  Memory memory() const;

 private:
  std::shared_ptr<const DriverApi> driver_;
  CUdevice device_ = 0;
  CUcontext context_ = nullptr;
  GpuFacts facts_;
};

}  // namespace raywalk::cuda
