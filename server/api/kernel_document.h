// The listing of compiled kernels as JSON.
#pragma once
#include <string>
#include <vector>

#include "server/device/cuda/kernel_listing.h"

namespace raywalk::api {

/// {"nvrtc": "13.0", "kernels": [...]}, an object for each entry point.
std::string kernel_document(const std::string& nvrtc_version, const std::vector<cuda::ListedKernel>& kernels);

}  // namespace raywalk::api
