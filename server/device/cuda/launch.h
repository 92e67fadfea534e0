// Streams, modules, launches of kernels and their time.
#pragma once
#include <array>

#include "server/device/cuda/handle.h"

namespace raywalk::cuda {

/// A queue of work that waits for no other stream.
class Stream {
 public:
  /// Throws CudaError.
  explicit Stream(const std::shared_ptr<const Context>& context);
  CUstream get() const { return handle_.get(); }
  const DriverApi& driver() const { return handle_.context().driver(); }
  /// Waits for all that was queued. Throws CudaError, also of the kernels that ran.
  void synchronize() const;

 private:
  Handle<CUstream, &DriverApi::cuStreamDestroy> handle_;
};

class Event {
 public:
  /// Throws CudaError.
  explicit Event(const std::shared_ptr<const Context>& context);
  CUevent get() const { return handle_.get(); }
  const DriverApi& driver() const { return handle_.context().driver(); }
  void record(const Stream& stream) const;
  void synchronize() const;

 private:
  Handle<CUevent, &DriverApi::cuEventDestroy> handle_;
};

/// The device's own time between two places of a stream.
class Timer {
 public:
  explicit Timer(const std::shared_ptr<const Context>& context) : start_(context), stop_(context) {}
  void start(const Stream& stream) { start_.record(stream); }
  void stop(const Stream& stream) { stop_.record(stream); }
  /// Waits for the end. Throws CudaError.
  double ms() const;

 private:
  Event start_, stop_;
};

/// Machine code on the device.
class Module {
 public:
  /// Throws CudaError when the driver refuses `image`.
  Module(const std::shared_ptr<const Context>& context, const void* image);
  /// Throws CudaError when there is none of that name.
  CUfunction function(const char* name) const;

 private:
  Handle<CUmodule, &DriverApi::cuModuleUnload> handle_;
};

struct Grid {
  u32 x = 1, y = 1;
  u32 block = 1;  // threads
};

/// Launches kernels, and lets one of them fail when tests ask for it.
class Launcher {
 public:
  /// Kernel number `fault_after`, counted from 1, is replaced by `fault`; 0: none.
  Launcher(const Stream& stream, u64 fault_after, CUfunction fault)
      : stream_(stream), fault_after_(fault_after), fault_(fault) {}

  /// `arguments` have exactly the types of the kernel's parameters; an address is a CUdeviceptr. Throws CudaError.
  template <class... Arguments>
  void operator()(CUfunction kernel, const Grid& grid, const Arguments&... arguments) {
    std::array<void*, sizeof...(Arguments)> pointers{const_cast<void*>(static_cast<const void*>(&arguments))...};
    launch(kernel, grid, pointers.data());
  }

 private:
  void launch(CUfunction kernel, const Grid& grid, void** arguments);
  const Stream& stream_;
  u64 launches_ = 0, fault_after_;
  CUfunction fault_;
};

}  // namespace raywalk::cuda
