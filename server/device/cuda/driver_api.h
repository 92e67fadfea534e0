// The CUDA driver, opened at run time: one list of the calls that Raywalk makes, and a struct filled in from it.
#pragma once
#include <memory>

#include "server/device/cuda/driver_types.h"
#include "server/device/cuda/library.h"

// X(call, symbol in the library, parameters...); every call returns a CUresult.
#define RW_DRIVER_CALLS(X)                                                                                           \
  X(cuInit, "cuInit", unsigned flags)                                                                                \
  X(cuDriverGetVersion, "cuDriverGetVersion", int* version)                                                          \
  X(cuGetErrorName, "cuGetErrorName", CUresult error, const char** text)                                             \
  X(cuGetErrorString, "cuGetErrorString", CUresult error, const char** text)                                         \
  X(cuDeviceGetCount, "cuDeviceGetCount", int* count)                                                                \
  X(cuDeviceGet, "cuDeviceGet", CUdevice* device, int ordinal)                                                       \
  X(cuDeviceGetName, "cuDeviceGetName", char* name, int capacity_bytes, CUdevice device)                             \
  X(cuDeviceGetAttribute, "cuDeviceGetAttribute", int* value, CUdevice_attribute attribute, CUdevice device)         \
  X(cuDeviceTotalMem, "cuDeviceTotalMem_v2", size_t* size_bytes, CUdevice device)                                    \
  X(cuDevicePrimaryCtxRetain, "cuDevicePrimaryCtxRetain", CUcontext* context, CUdevice device)                       \
  X(cuDevicePrimaryCtxRelease, "cuDevicePrimaryCtxRelease_v2", CUdevice device)                                      \
  X(cuCtxSetCurrent, "cuCtxSetCurrent", CUcontext context)                                                           \
  X(cuMemGetInfo, "cuMemGetInfo_v2", size_t* free_bytes, size_t* total_bytes)                                        \
  X(cuMemAlloc, "cuMemAlloc_v2", CUdeviceptr* memory, size_t size_bytes)                                             \
  X(cuMemFree, "cuMemFree_v2", CUdeviceptr memory)                                                                   \
  X(cuMemHostAlloc, "cuMemHostAlloc", void** memory, size_t size_bytes, unsigned flags)                              \
  X(cuMemFreeHost, "cuMemFreeHost", void* memory)                                                                    \
  X(cuMemcpyHtoDAsync, "cuMemcpyHtoDAsync_v2", CUdeviceptr to, const void* from, size_t size_bytes, CUstream stream) \
  X(cuMemcpyDtoHAsync, "cuMemcpyDtoHAsync_v2", void* to, CUdeviceptr from, size_t size_bytes, CUstream stream)       \
  X(cuMemsetD8Async, "cuMemsetD8Async", CUdeviceptr to, unsigned char value, size_t size_bytes, CUstream stream)     \
  X(cuStreamCreate, "cuStreamCreate", CUstream* stream, unsigned flags)                                              \
  X(cuStreamDestroy, "cuStreamDestroy_v2", CUstream stream)                                                          \
  X(cuStreamSynchronize, "cuStreamSynchronize", CUstream stream)                                                     \
  X(cuEventCreate, "cuEventCreate", CUevent* event, unsigned flags)                                                  \
  X(cuEventDestroy, "cuEventDestroy_v2", CUevent event)                                                              \
  X(cuEventRecord, "cuEventRecord", CUevent event, CUstream stream)                                                  \
  X(cuEventSynchronize, "cuEventSynchronize", CUevent event)                                                         \
  X(cuEventElapsedTime, "cuEventElapsedTime", float* elapsed_ms, CUevent start, CUevent end)                         \
  X(cuModuleLoadData, "cuModuleLoadData", CUmodule* module, const void* image)                                       \
  X(cuModuleUnload, "cuModuleUnload", CUmodule module)                                                               \
  X(cuModuleGetFunction, "cuModuleGetFunction", CUfunction* function, CUmodule module, const char* name)             \
  X(cuFuncGetAttribute, "cuFuncGetAttribute", int* value, CUfunction_attribute attribute, CUfunction function)       \
  X(cuLaunchKernel, "cuLaunchKernel", CUfunction function, unsigned grid_x, unsigned grid_y, unsigned grid_z,        \
    unsigned block_x, unsigned block_y, unsigned block_z, unsigned shared_bytes, CUstream stream, void** parameters, \
    void** extra)                                                                                                    \
  X(cuOccupancyMaxActiveBlocksPerMultiprocessor, "cuOccupancyMaxActiveBlocksPerMultiprocessor", int* blocks,         \
    CUfunction function, int block_threads, size_t shared_bytes)

namespace raywalk::cuda {

/// The oldest driver that is good enough, as cuDriverGetVersion tells it: CUDA 12.0.
constexpr int kOldestDriver = 12000;

struct DriverApi {
#define RW_DRIVER_MEMBER(call, symbol, ...) CUresult (*call)(__VA_ARGS__) = nullptr;
  RW_DRIVER_CALLS(RW_DRIVER_MEMBER)
#undef RW_DRIVER_MEMBER

  std::shared_ptr<const Library> library;
  int version = 0;  // CUDA that the driver supports: 1000 * major + 10 * minor
};

/// Opens libcuda.so.1, or the library that the environment variable RAYWALK_LIBCUDA names, and starts it (cuInit).
/// There is no value when the library or one of its symbols is missing, when the driver is too old, and when it does
/// not start, for instance without a device.
Found<DriverApi> open_driver();

/// "12.4" of 12040.
std::string version_text(int version);

}  // namespace raywalk::cuda
