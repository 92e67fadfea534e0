// From a kernel's specification to machine code, by NVRTC, with a cache on disk.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/device/cuda/kernel_spec.h"
#include "server/device/cuda/library.h"
#include "server/device/device.h"

namespace raywalk::cuda {

class CubinCache;
struct NvrtcApi;

/// The compiler refused the sources or the options; `what` holds its log.
class CompileError : public KernelRefused {
 public:
  using KernelRefused::KernelRefused;
};

/// What the assembler says of one entry point.
struct EntryReport {
  std::string entry;
  u32 registers = 0;
  u32 stack_bytes = 0, spill_store_bytes = 0, spill_load_bytes = 0;
  u32 shared_bytes = 0;
};

struct Compiled {
  std::vector<char> cubin;
  std::vector<EntryReport> entries;
  bool cached = false;
};

/// Safe to use from several threads, and with several processes on one cache folder.
class Compiler {
 public:
  /// `architecture` such as "sm_90". `cache_dir` may be empty: nothing is kept.
  Compiler(std::shared_ptr<const NvrtcApi> nvrtc, std::string architecture, std::filesystem::path cache_dir);
  ~Compiler();

  /// Throws CompileError. A cached file that is damaged or of another version is compiled anew.
  Compiled compile(const KernelSpec& spec) const;

 private:
  std::shared_ptr<const NvrtcApi> nvrtc_;
  std::string architecture_;
  std::unique_ptr<CubinCache> cache_;
};

}  // namespace raywalk::cuda
