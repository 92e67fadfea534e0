// Opens NVML and says what is wrong with it.
#include "server/device/cuda/nvml_api.h"

#include "server/device/cuda/environment.h"

namespace raywalk::cuda {

Found<NvmlApi> open_nvml() {
  const Found<Library> library = Library::open(named_or("RAYWALK_LIBNVML", "libnvidia-ml.so.1"));
  if (!library) return {nullptr, "There is no NVML. " + library.why_not};

  auto api = std::make_unique<NvmlApi>();
  api->library = library.value;
  std::string missing;
#define RW_BIND(call, symbol, ...) bind(*library.value, symbol, api->call, missing);
  RW_NVML_CALLS(RW_BIND)
#undef RW_BIND
  bind(*library.value, "nvmlErrorString", api->nvmlErrorString, missing);
  const std::string where = "NVML (" + library.value->path() + ") ";
  if (!missing.empty()) return {nullptr, where + "lacks " + missing + "."};
  if (const nvmlReturn_t result = api->nvmlInit(); result != NVML_SUCCESS) {
    return {nullptr, where + "does not start: " + api->nvmlErrorString(result) + "."};
  }
  return {std::shared_ptr<const NvmlApi>(api.release(),
                                         [](const NvmlApi* started) {
                                           started->nvmlShutdown();
                                           delete started;
                                         }),
          {}};
}

}  // namespace raywalk::cuda
