// Flags of the daemon.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

struct Flags {
  std::string host = "127.0.0.1";
  int port = 7979;
  std::filesystem::path port_file;  // gets the chosen port; empty: none
  std::string device = "auto";      // auto, cpu, cuda
  std::filesystem::path state_dir;
  std::filesystem::path kernel_cache_dir;  // compiled GPU kernels
  u64 device_memory_mib = 0;               // most that a GPU allocates; 0: all that it has
  u64 fault_after = 0;                     // number of the GPU's kernel launch that traps; 0: none
  u32 threads = 0;                         // 0: all processors
  std::filesystem::path scenes_dir;
  std::filesystem::path data_dir;
  std::string log_level = "info";
  bool log_json = false;
  bool die_with_parent = false;
  bool supervise = false;
  std::vector<std::string> compile_kernels;  // architectures; not empty: compile, print and end
};

/// Reads the command line; folders have their defaults afterwards. The value is the exit code when the program should
/// end at once (help, version, a bad flag).
struct FlagsOrExit {
  Flags flags;
  std::optional<int> exit_code;
};
FlagsOrExit parse_flags(int argc, char** argv);

}  // namespace raywalk
