// The run-time compiler NVRTC, opened at run time: one list of its calls, and a struct filled in from it.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "server/device/cuda/library.h"

namespace raywalk::cuda {

using nvrtcProgram = struct _nvrtcProgram*;
enum nvrtcResult : int { NVRTC_SUCCESS = 0, NVRTC_ERROR_COMPILATION = 6 };

}  // namespace raywalk::cuda

// X(call, parameters...); every call returns an nvrtcResult.
#define RW_NVRTC_CALLS(X)                                                                              \
  X(nvrtcVersion, int* major, int* minor)                                                              \
  X(nvrtcGetNumSupportedArchs, int* count)                                                             \
  X(nvrtcGetSupportedArchs, int* architectures)                                                        \
  X(nvrtcCreateProgram, nvrtcProgram* program, const char* source, const char* name, int header_count, \
    const char* const* headers, const char* const* include_names)                                      \
  X(nvrtcCompileProgram, nvrtcProgram program, int option_count, const char* const* options)           \
  X(nvrtcGetProgramLogSize, nvrtcProgram program, size_t* size_bytes)                                  \
  X(nvrtcGetProgramLog, nvrtcProgram program, char* log)                                               \
  X(nvrtcGetCUBINSize, nvrtcProgram program, size_t* size_bytes)                                       \
  X(nvrtcGetCUBIN, nvrtcProgram program, char* cubin)                                                  \
  X(nvrtcDestroyProgram, nvrtcProgram* program)

namespace raywalk::cuda {

struct NvrtcApi {
#define RW_NVRTC_MEMBER(call, ...) nvrtcResult (*call)(__VA_ARGS__) = nullptr;
  RW_NVRTC_CALLS(RW_NVRTC_MEMBER)
#undef RW_NVRTC_MEMBER
  const char* (*nvrtcGetErrorString)(nvrtcResult result) = nullptr;

  std::shared_ptr<const Library> library;
  std::shared_ptr<const Library> builtins;  // what NVRTC opens by name when it compiles; null where the loader finds it
  int major = 0, minor = 0;
  std::string identity;  // of this very build, see Library

  /// "13.0".
  std::string version() const {
    return std::to_string(major) + '.' + std::to_string(minor);
  }
  /// Such as {"sm_80", "sm_90"}, in the compiler's order.
  std::vector<std::string> architectures() const;
};

/// As a sentence lists them: "sm_80, sm_90".
std::string joined(const std::vector<std::string>& architectures);

/// The oldest NVRTC that is good enough, as 1000 * major + 10 * minor: 12.4 is the first that knows __maxnreg__.
constexpr int kOldestNvrtc = 12040;

/// Where open_nvrtc looks, in that order: the libraries that the environment variable RAYWALK_NVRTC names, separated by
/// colons, and nothing else, or what the loader finds, the usual folders of CUDA toolkits, and a Python environment:
/// $VIRTUAL_ENV, or .venv beside the program or above it.
std::vector<std::string> nvrtc_places();

/// The first that can be opened, is not too old, and whose machine code a driver for the CUDA of `driver_version` (as
/// DriverApi has it; 0: any) can load: one of its major version or an older one.
Found<NvrtcApi> open_nvrtc(int driver_version = 0);

}  // namespace raywalk::cuda
