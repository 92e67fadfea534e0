// The traversals that kernels can be compiled for, by the names of their types.
#pragma once
#include <string_view>
#include <vector>

#include "kernels/platform.h"

namespace raywalk::cuda {

/// A row of RW_TRAVERSALS.
struct TraversalType {
  std::string_view type;  // KernelSpec::traversal, such as "BvhWhileWhile"
  std::string_view structure, traversal, help;
  u32 group = 1;  // rays that run together
  u32 knobs = 0;  // kKnobSlab, kKnobStack
};

/// In the order of RW_TRAVERSALS.
const std::vector<TraversalType>& traversal_types();

}  // namespace raywalk::cuda
