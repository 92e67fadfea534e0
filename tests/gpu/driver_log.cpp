// Functions that note a call and pass it on to the fake driver.
#include "tests/gpu/driver_log.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>

#include "tests/gpu/fake_driver.h"
#include "tests/support/environment.h"

namespace raywalk::test {
namespace {

using namespace cuda;

DriverApi fake;
std::map<CUfunction, std::string> kernel_names;

void note(const std::string& call) {
  driver_log().calls.push_back(call);
}

/// Every entry point as a function of its own, since the fake gives all of a module the same.
CUresult get_function(CUfunction* function, CUmodule, const char* name) {
  static std::vector<std::unique_ptr<char>> handles;
  handles.push_back(std::make_unique<char>());
  *function = reinterpret_cast<CUfunction>(handles.back().get());
  kernel_names[*function] = name;
  return CUDA_SUCCESS;
}

void add_log(DriverApi& api) {
  api.cuMemAlloc = [](CUdeviceptr* memory, size_t size_bytes) {
    note("cuMemAlloc");
    return fake.cuMemAlloc(memory, size_bytes);
  };
  api.cuMemFree = [](CUdeviceptr memory) {
    note("cuMemFree");
    return fake.cuMemFree(memory);
  };
  api.cuMemcpyHtoDAsync = [](CUdeviceptr to, const void* from, size_t size_bytes, CUstream stream) {
    note("cuMemcpyHtoD");
    return fake.cuMemcpyHtoDAsync(to, from, size_bytes, stream);
  };
  api.cuMemcpyDtoHAsync = [](void* to, CUdeviceptr from, size_t size_bytes, CUstream stream) {
    note("cuMemcpyDtoH");
    return fake.cuMemcpyDtoHAsync(to, from, size_bytes, stream);
  };
  api.cuStreamSynchronize = [](CUstream stream) {
    note("cuStreamSynchronize");
    return fake.cuStreamSynchronize(stream);
  };
  api.cuEventRecord = [](CUevent event, CUstream stream) {
    note("cuEventRecord");
    return fake.cuEventRecord(event, stream);
  };
  api.cuModuleGetFunction = get_function;
  api.cuLaunchKernel = [](CUfunction kernel, unsigned x, unsigned y, unsigned z, unsigned block_x, unsigned block_y,
                          unsigned block_z, unsigned shared, CUstream stream, void** parameters, void** extra) {
    note(kernel_names[kernel]);
    return fake.cuLaunchKernel(kernel, x, y, z, block_x, block_y, block_z, shared, stream, parameters, extra);
  };
}

}  // namespace

u64 DriverLog::count(const std::string& name) const {
  return static_cast<u64>(std::count(calls.begin(), calls.end(), name));
}

DriverLog& driver_log() {
  static DriverLog log;
  return log;
}

std::shared_ptr<const DriverApi> logged_driver() {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda"));
  fake = {};
  const Found<DriverApi> opened = open_driver();
  if (!opened) throw std::runtime_error(opened.why_not);
  fake = *opened.value;
  fake.library.reset();  // the caller's pointer keeps it
  driver_log() = {};
  const auto api = std::make_shared<DriverApi>(*opened.value);
  add_log(*api);
  return api;
}

std::shared_ptr<const NvrtcApi> logged_compiler() {
  const auto api = std::make_shared<NvrtcApi>();
  api->major = 13;
  api->nvrtcGetErrorString = [](nvrtcResult) { return "no error"; };
  api->nvrtcCreateProgram = [](nvrtcProgram* program, const char*, const char*, int, const char* const*,
                               const char* const*) {
    *program = nullptr;
    return NVRTC_SUCCESS;
  };
  api->nvrtcCompileProgram = [](nvrtcProgram, int, const char* const*) {
    note("nvrtcCompileProgram");
    return NVRTC_SUCCESS;
  };
  api->nvrtcGetProgramLogSize = [](nvrtcProgram, size_t* size_bytes) {
    *size_bytes = 0;
    return NVRTC_SUCCESS;
  };
  api->nvrtcGetProgramLog = [](nvrtcProgram, char*) { return NVRTC_SUCCESS; };
  api->nvrtcGetCUBINSize = [](nvrtcProgram, size_t* size_bytes) {
    *size_bytes = 4;
    return NVRTC_SUCCESS;
  };
  api->nvrtcGetCUBIN = [](nvrtcProgram, char* cubin) {
    std::memcpy(cubin, "code", 4);
    return NVRTC_SUCCESS;
  };
  api->nvrtcDestroyProgram = [](nvrtcProgram*) { return NVRTC_SUCCESS; };
  return api;
}

}  // namespace raywalk::test
