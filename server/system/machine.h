// The machine record: where a result was measured, and with which build.
#pragma once
#include <map>
#include <string>

#include "kernels/platform.h"

namespace raywalk {

struct Machine {
  std::string fingerprint;  // hash of what must be equal for times to be comparable
  std::string hostname, os, kernel, cpu;
  u32 cores = 1;    // logical processors
  u32 threads = 1;  // that render
  u64 memory_bytes = 0;
  std::string governor;  // frequency governor, or "unknown"
  std::string device;
  std::map<std::string, std::string> device_details;  // driver, compiler and the like by name
  std::string compiler, build_type, build_flags, version, git_commit;
  std::map<std::string, std::string> libraries;  // name to version
};

/// Reads /proc, /sys and /etc/os-release; what cannot be read is "unknown".
Machine describe_machine(const std::string& device, const std::map<std::string, std::string>& device_details,
                         u32 threads);

}  // namespace raywalk
