// The fake driver with a log of the calls that matter, and a compiler that makes machine code of anything.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "server/device/cuda/driver_api.h"
#include "server/device/cuda/nvrtc_api.h"

namespace raywalk::test {

/// Allocations, copies, event records and compilations by their name, launches by the kernel's.
struct DriverLog {
  std::vector<std::string> calls;
  u64 count(const std::string& name) const;
};
DriverLog& driver_log();

/// Opens the fake driver and clears the log.
std::shared_ptr<const cuda::DriverApi> logged_driver();
std::shared_ptr<const cuda::NvrtcApi> logged_compiler();

}  // namespace raywalk::test
