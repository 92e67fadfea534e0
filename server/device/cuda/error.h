// Failed calls of the CUDA driver, as exceptions.
#pragma once
#include <source_location>
#include <stdexcept>

#include "server/device/cuda/driver_api.h"

namespace raywalk::cuda {

/// `what` has the call, the error's name and text, and the place of the call.
class CudaError : public std::runtime_error {
 public:
  CudaError(CUresult code, const std::string& what) : std::runtime_error(what), code_(code) {}
  CUresult code() const { return code_; }
  /// After such an error every later call fails too: only a new process can use the device again.
  bool context_is_lost() const;

 private:
  CUresult code_;
};

/// "CUDA_ERROR_OUT_OF_MEMORY (out of memory)"; the number where the driver does not know the error.
std::string describe(const DriverApi& api, CUresult result);

/// Throws CudaError unless `result` is a success. `call` is the name of the call that returned it.
void check(const DriverApi& api, CUresult result, const char* call,
           std::source_location place = std::source_location::current());

}  // namespace raywalk::cuda

/// A checked call: RW_CUDA(api, cuMemFree, memory) throws CudaError.
#define RW_CUDA(api, call, ...) ::raywalk::cuda::check((api), (api).call(__VA_ARGS__), #call)
