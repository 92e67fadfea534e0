// The list of traversals as data.
#include "server/device/cuda/traversal_types.h"

#include "kernels/accel/traversals.h"

namespace raywalk::cuda {

const std::vector<TraversalType>& traversal_types() {
#define RW_TYPE_ROW(type, space, structure, traversal, group, knobs, help) \
  {#type, structure, traversal, help, group, knobs},
  static const std::vector<TraversalType> table = {RW_TRAVERSALS(RW_TYPE_ROW)};
#undef RW_TYPE_ROW
  return table;
}

}  // namespace raywalk::cuda
