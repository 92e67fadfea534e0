// Kernels ready to be launched: compiled and loaded at their first use.
#pragma once
#include <map>

#include "server/device/cuda/compiler.h"
#include "server/device/cuda/launch.h"
#include "server/device/device.h"

namespace raywalk::cuda {

struct Kernel {
  CUfunction function = nullptr;
  KernelFigures figures;
  bool ran = false;  // set by whoever launches it: the driver prepares a kernel at its first launch
};

class KernelStore {
 public:
  KernelStore(std::shared_ptr<const Context> context, std::shared_ptr<const Compiler> compiler)
      : context_(std::move(context)), compiler_(std::move(compiler)) {}

  /// `entry` is one of the functions of the spec's program. Stays where it is. Throws CompileError and CudaError.
  Kernel& get(const KernelSpec& spec, const std::string& entry);

 private:
  struct Loaded {
    Module module;
    u64 binary_bytes;
    std::map<std::string, Kernel> kernels;
  };
  Loaded& loaded(const KernelSpec& spec);

  std::shared_ptr<const Context> context_;
  std::shared_ptr<const Compiler> compiler_;
  std::map<KernelSpec, Loaded> loaded_;
};

}  // namespace raywalk::cuda
