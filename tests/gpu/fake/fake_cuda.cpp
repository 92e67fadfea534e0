// A driver without a device, for tests of all that surrounds the kernels: a shared library with the calls of libcuda
// that Raywalk makes. Device memory is host memory, copies copy, modules take any bytes, launches do nothing.
//   FAKE_CUDA_VERSION        of the driver, as cuDriverGetVersion tells it (default 13000)
//   FAKE_CUDA_DEVICES        how many there are (default 1)
//   FAKE_CUDA_CAPABILITY     of the devices: 10 * major + minor (default 90)
//   FAKE_CUDA_MEMORY_BYTES   of the device (default 1 GiB)
//   FAKE_CUDA_FAIL_LAUNCH    number of the launch that fails, from 1; every call after it fails too (default none)
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "server/device/cuda/driver_types.h"

namespace raywalk::cuda {

struct CUctx_st {};
struct CUfunc_st {};
struct CUmod_st {
  CUfunc_st function;
};
struct CUstream_st {};
struct CUevent_st {
  std::chrono::steady_clock::time_point recorded;
};

}  // namespace raywalk::cuda

using namespace raywalk;
using namespace raywalk::cuda;

namespace {

u64 setting(const char* name, u64 fallback) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::strtoull(value, nullptr, 10) : fallback;
}

/// Everything between cuInit and the end of the process. Locked by each call.
struct Driver {
  std::mutex mutex;
  bool started = false;
  CUresult broken = CUDA_SUCCESS;  // what every call returns after a failed launch
  u64 launches = 0;
  u64 used_bytes = 0;
  std::map<CUdeviceptr, std::unique_ptr<std::vector<u8>>> memory;
  CUctx_st context;

  u64 total_bytes() const { return setting("FAKE_CUDA_MEMORY_BYTES", u64{1} << 30); }
  /// Whether [start, start + size) lies in one allocation.
  bool holds(CUdeviceptr start, size_t size) const {
    auto after = memory.upper_bound(start);
    if (after == memory.begin()) return false;
    const auto& [first, bytes] = *std::prev(after);
    return start - first <= bytes->size() && size <= bytes->size() - (start - first);
  }
};

Driver& driver() {
  static Driver the_driver;
  return the_driver;
}

/// The state of the driver, locked; calls that need cuInit or a good context return `result` when it is not a success.
struct Call {
  Driver& state = driver();
  std::lock_guard<std::mutex> lock{state.mutex};
  CUresult result = state.started ? state.broken : CUDA_ERROR_NOT_INITIALIZED;
};

CUresult succeed_unless(bool bad) {
  return bad ? CUDA_ERROR_INVALID_VALUE : CUDA_SUCCESS;
}

u8* bytes_at(CUdeviceptr place) {
  return reinterpret_cast<u8*>(place);
}

/// Figures of an H100, where nothing else is asked for.
int attribute_value(CUdevice_attribute attribute) {
  switch (attribute) {
    case CU_DEVICE_ATTRIBUTE_MULTIPROCESSOR_COUNT:
      return 132;
    case CU_DEVICE_ATTRIBUTE_PCI_BUS_ID:
      return 1;
    case CU_DEVICE_ATTRIBUTE_MAX_THREADS_PER_MULTIPROCESSOR:
      return 2048;
    case CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR:
      return static_cast<int>(setting("FAKE_CUDA_CAPABILITY", 90) / 10);
    case CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR:
      return static_cast<int>(setting("FAKE_CUDA_CAPABILITY", 90) % 10);
    default:
      return 0;
  }
}

}  // namespace

extern "C" {

CUresult cuDriverGetVersion(int* version) {
  *version = static_cast<int>(setting("FAKE_CUDA_VERSION", 13000));
  return CUDA_SUCCESS;
}

CUresult cuInit(unsigned flags) {
  Call call;
  if (setting("FAKE_CUDA_DEVICES", 1) == 0) return CUDA_ERROR_NO_DEVICE;
  call.state.started = true;
  return succeed_unless(flags != 0);
}

CUresult cuGetErrorName(CUresult error, const char** text) {
  switch (error) {
    case CUDA_SUCCESS:
      *text = "CUDA_SUCCESS";
      break;
    case CUDA_ERROR_INVALID_VALUE:
      *text = "CUDA_ERROR_INVALID_VALUE";
      break;
    case CUDA_ERROR_OUT_OF_MEMORY:
      *text = "CUDA_ERROR_OUT_OF_MEMORY";
      break;
    case CUDA_ERROR_NOT_INITIALIZED:
      *text = "CUDA_ERROR_NOT_INITIALIZED";
      break;
    case CUDA_ERROR_NO_DEVICE:
      *text = "CUDA_ERROR_NO_DEVICE";
      break;
    case CUDA_ERROR_INVALID_DEVICE:
      *text = "CUDA_ERROR_INVALID_DEVICE";
      break;
    case CUDA_ERROR_LAUNCH_FAILED:
      *text = "CUDA_ERROR_LAUNCH_FAILED";
      break;
    default:
      *text = nullptr;
      return CUDA_ERROR_INVALID_VALUE;
  }
  return CUDA_SUCCESS;
}

CUresult cuGetErrorString(CUresult error, const char** text) {
  const CUresult known = cuGetErrorName(error, text);
  if (known == CUDA_SUCCESS) *text = "an error of the fake driver";
  return known;
}

CUresult cuDeviceGetCount(int* count) {
  const Call call;
  *count = static_cast<int>(setting("FAKE_CUDA_DEVICES", 1));
  return call.result;
}

CUresult cuDeviceGet(CUdevice* device, int ordinal) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (ordinal < 0 || ordinal >= static_cast<int>(setting("FAKE_CUDA_DEVICES", 1))) return CUDA_ERROR_INVALID_DEVICE;
  *device = ordinal;
  return CUDA_SUCCESS;
}

CUresult cuDeviceGetName(char* name, int capacity_bytes, CUdevice) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (capacity_bytes <= 0) return CUDA_ERROR_INVALID_VALUE;
  std::strncpy(name, "Fake GPU", static_cast<size_t>(capacity_bytes));
  name[capacity_bytes - 1] = '\0';
  return CUDA_SUCCESS;
}

CUresult cuDeviceGetAttribute(int* value, CUdevice_attribute attribute, CUdevice) {
  const Call call;
  *value = attribute_value(attribute);
  return call.result;
}

CUresult cuDeviceTotalMem_v2(size_t* size_bytes, CUdevice) {
  const Call call;
  *size_bytes = call.state.total_bytes();
  return call.result;
}

CUresult cuDevicePrimaryCtxRetain(CUcontext* context, CUdevice) {
  const Call call;
  *context = &call.state.context;
  return call.result;
}

CUresult cuDevicePrimaryCtxRelease_v2(CUdevice) {
  return Call().result;
}

CUresult cuCtxSetCurrent(CUcontext) {
  return Call().result;
}

CUresult cuMemGetInfo_v2(size_t* free_bytes, size_t* total_bytes) {
  const Call call;
  *total_bytes = call.state.total_bytes();
  *free_bytes = *total_bytes > call.state.used_bytes ? *total_bytes - call.state.used_bytes : 0;
  return call.result;
}

CUresult cuMemAlloc_v2(CUdeviceptr* memory, size_t size_bytes) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (size_bytes == 0) return CUDA_ERROR_INVALID_VALUE;
  if (call.state.used_bytes + size_bytes > call.state.total_bytes()) return CUDA_ERROR_OUT_OF_MEMORY;
  auto bytes = std::make_unique<std::vector<u8>>(size_bytes);
  *memory = reinterpret_cast<CUdeviceptr>(bytes->data());
  call.state.memory.emplace(*memory, std::move(bytes));
  call.state.used_bytes += size_bytes;
  return CUDA_SUCCESS;
}

CUresult cuMemFree_v2(CUdeviceptr memory) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  const auto found = call.state.memory.find(memory);
  if (found == call.state.memory.end()) return succeed_unless(memory != 0);
  call.state.used_bytes -= found->second->size();
  call.state.memory.erase(found);
  return CUDA_SUCCESS;
}

CUresult cuMemHostAlloc(void** memory, size_t size_bytes, unsigned) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  *memory = std::malloc(size_bytes);
  return *memory != nullptr ? CUDA_SUCCESS : CUDA_ERROR_OUT_OF_MEMORY;
}

CUresult cuMemFreeHost(void* memory) {
  const Call call;
  std::free(memory);
  return call.result;
}

CUresult cuMemcpyHtoDAsync_v2(CUdeviceptr to, const void* from, size_t size_bytes, CUstream) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (!call.state.holds(to, size_bytes)) return CUDA_ERROR_INVALID_VALUE;
  std::memcpy(bytes_at(to), from, size_bytes);
  return CUDA_SUCCESS;
}

CUresult cuMemcpyDtoHAsync_v2(void* to, CUdeviceptr from, size_t size_bytes, CUstream) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (!call.state.holds(from, size_bytes)) return CUDA_ERROR_INVALID_VALUE;
  std::memcpy(to, bytes_at(from), size_bytes);
  return CUDA_SUCCESS;
}

CUresult cuMemsetD8Async(CUdeviceptr to, unsigned char value, size_t size_bytes, CUstream) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (!call.state.holds(to, size_bytes)) return CUDA_ERROR_INVALID_VALUE;
  std::memset(bytes_at(to), value, size_bytes);
  return CUDA_SUCCESS;
}

CUresult cuStreamCreate(CUstream* stream, unsigned) {
  const Call call;
  if (call.result == CUDA_SUCCESS) *stream = new CUstream_st;
  return call.result;
}

CUresult cuStreamDestroy_v2(CUstream stream) {
  const Call call;
  delete stream;
  return call.result;
}

CUresult cuStreamSynchronize(CUstream) {
  return Call().result;
}

CUresult cuEventCreate(CUevent* event, unsigned) {
  const Call call;
  if (call.result == CUDA_SUCCESS) *event = new CUevent_st;
  return call.result;
}

CUresult cuEventDestroy_v2(CUevent event) {
  const Call call;
  delete event;
  return call.result;
}

CUresult cuEventRecord(CUevent event, CUstream) {
  const Call call;
  event->recorded = std::chrono::steady_clock::now();
  return call.result;
}

CUresult cuEventSynchronize(CUevent) {
  return Call().result;
}

CUresult cuEventElapsedTime(float* elapsed_ms, CUevent start, CUevent end) {
  const Call call;
  *elapsed_ms = std::chrono::duration<float, std::milli>(end->recorded - start->recorded).count();
  return call.result;
}

CUresult cuModuleLoadData(CUmodule* module, const void* image) {
  const Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (image == nullptr) return CUDA_ERROR_INVALID_VALUE;
  *module = new CUmod_st;
  return CUDA_SUCCESS;
}

CUresult cuModuleUnload(CUmodule module) {
  const Call call;
  delete module;
  return call.result;
}

CUresult cuModuleGetFunction(CUfunction* function, CUmodule module, const char*) {
  const Call call;
  *function = &module->function;
  return call.result;
}

CUresult cuFuncGetAttribute(int* value, CUfunction_attribute attribute, CUfunction) {
  const Call call;
  *value = attribute == CU_FUNC_ATTRIBUTE_NUM_REGS ? 40 : 0;
  return call.result;
}

#ifndef FAKE_CUDA_INCOMPLETE
CUresult cuLaunchKernel(CUfunction, unsigned grid_x, unsigned grid_y, unsigned grid_z, unsigned block_x,
                        unsigned block_y, unsigned block_z, unsigned, CUstream, void**, void**) {
  Call call;
  if (call.result != CUDA_SUCCESS) return call.result;
  if (++call.state.launches == setting("FAKE_CUDA_FAIL_LAUNCH", 0)) return call.state.broken = CUDA_ERROR_LAUNCH_FAILED;
  const u64 blocks = u64{grid_x} * grid_y * grid_z, threads = u64{block_x} * block_y * block_z;
  return succeed_unless(blocks == 0 || threads == 0 || threads > 1024);
}
#endif

CUresult cuOccupancyMaxActiveBlocksPerMultiprocessor(int* blocks, CUfunction, int block_threads, size_t) {
  const Call call;
  if (block_threads <= 0) return CUDA_ERROR_INVALID_VALUE;
  *blocks = 1024 / block_threads;
  return call.result;
}

}  // extern "C"
