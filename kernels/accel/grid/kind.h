// Host only: the uniform grid as a kind of structure.
#pragma once
#include "kernels/accel/kind.h"

namespace raywalk::grid {

/// Kind "grid"; its traversal is `grid/dda`.
const Kind& kind();

}  // namespace raywalk::grid
