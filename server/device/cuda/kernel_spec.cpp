// Names of kernels.
#include "server/device/cuda/kernel_spec.h"

namespace raywalk::cuda {

std::string_view name_of(Program program) {
  switch (program) {
    case Program::frame:
      return "frame";
    case Program::trace:
      return "trace";
    case Program::count:
      return "count";
    case Program::fault:
      return "fault";
  }
  return "";
}

std::string KernelSpec::name() const {
  std::string text = std::string(name_of(program)) + ' ' + traversal + ' ' + intersector;
  if (slab != KernelSpec{}.slab) text += ' ' + slab;
  if (spawn != KernelSpec{}.spawn) text += ' ' + spawn;
  if (nodes != KernelSpec{}.nodes) text += ' ' + nodes;
  text += " features=" + std::to_string(features) + " mode=" + std::to_string(static_cast<u32>(mode));
  text += " block=" + std::to_string(block) + " stack_entries=" + std::to_string(stack_entries);
  if (registers > 0) text += " registers=" + std::to_string(registers);
  return text;
}

}  // namespace raywalk::cuda
