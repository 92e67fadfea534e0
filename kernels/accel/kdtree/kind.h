// Host only: the kd-tree as a kind of structure.
#pragma once
#include "kernels/accel/kind.h"

namespace raywalk::kdtree {

/// Kind "kdtree"; its traversals are `kdtree/short-stack-3` and `kdtree/short-stack-2`.
const Kind& kind();

}  // namespace raywalk::kdtree
