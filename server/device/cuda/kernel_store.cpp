// Compiles, loads, and asks the driver for the figures of a kernel.
#include "server/device/cuda/kernel_store.h"

namespace raywalk::cuda {
namespace {

KernelFigures figures_of(const Context& context, CUfunction function, u32 block, u64 binary_bytes) {
  const DriverApi& driver = context.driver();
  const auto attribute = [&](CUfunction_attribute which) {
    int value = 0;
    RW_CUDA(driver, cuFuncGetAttribute, &value, which, function);
    return static_cast<u32>(value);
  };
  int blocks = 0;
  RW_CUDA(driver, cuOccupancyMaxActiveBlocksPerMultiprocessor, &blocks, function, static_cast<int>(block), 0);
  KernelFigures figures;
  figures.registers = attribute(CU_FUNC_ATTRIBUTE_NUM_REGS);
  figures.local_bytes = attribute(CU_FUNC_ATTRIBUTE_LOCAL_SIZE_BYTES);
  figures.shared_bytes = attribute(CU_FUNC_ATTRIBUTE_SHARED_SIZE_BYTES);
  figures.threads_per_block = block;
  figures.blocks_per_multiprocessor = static_cast<u32>(blocks);
  figures.occupancy =
      static_cast<double>(figures.blocks_per_multiprocessor) * block / context.facts().threads_per_multiprocessor;
  figures.binary_bytes = binary_bytes;
  return figures;
}

}  // namespace

KernelStore::Loaded& KernelStore::loaded(const KernelSpec& spec) {
  const auto known = loaded_.find(spec);
  if (known != loaded_.end()) return known->second;
  const Compiled compiled = compiler_->compile(spec);
  return loaded_.emplace(spec, Loaded{Module(context_, compiled.cubin.data()), compiled.cubin.size(), {}})
      .first->second;
}

Kernel& KernelStore::get(const KernelSpec& spec, const std::string& entry) {
  Loaded& program = loaded(spec);
  const auto known = program.kernels.find(entry);
  if (known != program.kernels.end()) return known->second;
  const CUfunction function = program.module.function(entry.c_str());
  const Kernel kernel{function, figures_of(*context_, function, spec.block, program.binary_bytes)};
  return program.kernels.emplace(entry, kernel).first->second;
}

}  // namespace raywalk::cuda
