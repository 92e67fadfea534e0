// Compiler -> listing -> JSON.
#include "server/compile_kernels.h"

#include <cstdio>

#include "server/api/kernel_document.h"
#include "server/device/cuda/nvrtc_api.h"
#include "server/exit_codes.h"

namespace raywalk {

int compile_kernels(const std::vector<std::string>& architectures, const std::filesystem::path& cache_dir) {
  const auto fail = [](int code, const std::string& sentence) {
    std::fprintf(stderr, "raywalkd: %s\n", sentence.c_str());
    return code;
  };
  const cuda::Found<cuda::NvrtcApi> nvrtc = cuda::open_nvrtc();
  if (!nvrtc) return fail(kNoDevice, nvrtc.why_not);
  try {
    const std::string text =
        api::kernel_document(nvrtc.value->version(), cuda::list_kernels(nvrtc.value, architectures, cache_dir));
    std::printf("%s\n", text.c_str());
    return kDone;
  } catch (const cuda::UnknownArchitecture& e) {
    return fail(kBadSetting, e.what());
  } catch (const cuda::CompileError& e) {
    return fail(kFailed, e.what());
  }
}

}  // namespace raywalk
