// Opens the driver and says what is wrong with it.
#include "server/device/cuda/driver_api.h"

#include "server/device/cuda/environment.h"
#include "server/device/cuda/error.h"

namespace raywalk::cuda {

std::string version_text(int version) {
  return std::to_string(version / 1000) + '.' + std::to_string(version % 1000 / 10);
}

Found<DriverApi> open_driver() {
  const Found<Library> library = Library::open(named_or("RAYWALK_LIBCUDA", "libcuda.so.1"));
  if (!library) return {nullptr, "There is no NVIDIA driver. " + library.why_not};

  const auto api = std::make_shared<DriverApi>();
  api->library = library.value;
  std::string missing;
#define RW_BIND(call, symbol, ...) bind(*library.value, symbol, api->call, missing);
  RW_DRIVER_CALLS(RW_BIND)
#undef RW_BIND
  const std::string where = "The NVIDIA driver (" + library.value->path() + ") ";

  // The version first: an old driver lacks symbols too, and its age is the better reason.
  if (api->cuDriverGetVersion != nullptr && api->cuDriverGetVersion(&api->version) == CUDA_SUCCESS &&
      api->version < kOldestDriver) {
    return {nullptr, where + "is too old: it supports CUDA " + version_text(api->version) + ", and CUDA " +
                         version_text(kOldestDriver) + " or newer is needed."};
  }
  if (!missing.empty()) return {nullptr, where + "lacks " + missing + "."};
  if (api->version == 0) return {nullptr, where + "does not tell its version."};
  if (const CUresult result = api->cuInit(0); result != CUDA_SUCCESS) {
    return {nullptr, where + "does not start: cuInit: " + describe(*api, result) + "."};
  }
  return {api, {}};
}

}  // namespace raywalk::cuda
