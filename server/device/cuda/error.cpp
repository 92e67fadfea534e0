// The text of a failed driver call.
#include "server/device/cuda/error.h"

namespace raywalk::cuda {
namespace {

/// A path of the source tree from its root on, whatever the compiler was called with.
std::string from_root(std::string path) {
  const size_t root = path.rfind("server/");
  return root == std::string::npos ? path : path.substr(root);
}

}  // namespace

bool CudaError::context_is_lost() const {
  switch (code_) {
    case CUDA_ERROR_ECC_UNCORRECTABLE:
    case CUDA_ERROR_NVLINK_UNCORRECTABLE:
    case CUDA_ERROR_ILLEGAL_ADDRESS:
    case CUDA_ERROR_LAUNCH_TIMEOUT:
    case CUDA_ERROR_ASSERT:
    case CUDA_ERROR_HARDWARE_STACK_ERROR:
    case CUDA_ERROR_ILLEGAL_INSTRUCTION:
    case CUDA_ERROR_MISALIGNED_ADDRESS:
    case CUDA_ERROR_INVALID_ADDRESS_SPACE:
    case CUDA_ERROR_INVALID_PC:
    case CUDA_ERROR_LAUNCH_FAILED:
    case CUDA_ERROR_UNKNOWN:
      return true;
    default:
      return false;
  }
}

std::string describe(const DriverApi& api, CUresult result) {
  const char* name = nullptr;
  const char* text = nullptr;
  if (api.cuGetErrorName(result, &name) != CUDA_SUCCESS || name == nullptr) {
    return "error " + std::to_string(static_cast<int>(result));
  }
  if (api.cuGetErrorString(result, &text) != CUDA_SUCCESS || text == nullptr) return name;
  return std::string(name) + " (" + text + ")";
}

void check(const DriverApi& api, CUresult result, const char* call, std::source_location place) {
  if (result == CUDA_SUCCESS) return;
  throw CudaError(result, std::string(call) + ": " + describe(api, result) + " at " + from_root(place.file_name()) +
                              ":" + std::to_string(place.line()));
}

}  // namespace raywalk::cuda
