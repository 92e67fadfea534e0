// Options of a traversal's kernel, and the kernel that a request runs.
#pragma once
#include "server/device/cuda/kernel_spec.h"
#include "server/device/cuda/traversal_types.h"
#include "server/device/device.h"

namespace raywalk::cuda {

/// Throws std::invalid_argument when there is none.
const TraversalType& traversal_type(const std::string& structure, const std::string& traversal);

/// registers, block, stack_entries (of a short stack), intersector.
std::vector<Option> kernel_options(const TraversalType& type);

/// The kernel for a structure of that form, of a scene that needs `features`. Features that cannot matter are left out,
/// so that requests share kernels. Throws std::invalid_argument for an unknown option, a value out of range, or a form
/// that does not go with the options.
KernelSpec kernel_spec(const TraversalType& type, const OptionValues& given, Program program, Mode mode, u32 features,
                       const StructureForm& form = {});

}  // namespace raywalk::cuda
