// A kernel compiler that only tells its version, for tests of how one is chosen.
//   FAKE_NVRTC_VERSION   1000 * major + 10 * minor (default 12010)
#include <cstdlib>

#include "server/device/cuda/nvrtc_api.h"

using namespace raywalk::cuda;

extern "C" {

nvrtcResult nvrtcVersion(int* major, int* minor) {
  const char* text = std::getenv("FAKE_NVRTC_VERSION");
  const int version = text != nullptr ? std::atoi(text) : 12010;
  *major = version / 1000;
  *minor = version % 1000 / 10;
  return NVRTC_SUCCESS;
}

}  // extern "C"
