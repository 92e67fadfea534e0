// All kernels that matter, compiled without a device: what the assembler says of each.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/device/cuda/compiler.h"

namespace raywalk::cuda {

/// Every traversal with every program and mode, with the fewest features and with all but textures, as requests without
/// options run them; with textures too where all features count; and one with the other ray-triangle test.
std::vector<KernelSpec> representative_kernels();

struct ListedKernel {
  std::string architecture;
  KernelSpec spec;
  EntryReport report;
};

/// The compiler has no such architecture; `what` names those that it has.
class UnknownArchitecture : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Compiles all representative kernels for each architecture, on all processors. In the order of `architectures`,
/// then of `representative_kernels`, then of the entry points. What `cache_dir` has is not compiled again. Throws
/// UnknownArchitecture and CompileError.
std::vector<ListedKernel> list_kernels(const std::shared_ptr<const NvrtcApi>& nvrtc,
                                       const std::vector<std::string>& architectures,
                                       const std::filesystem::path& cache_dir = {});

}  // namespace raywalk::cuda
