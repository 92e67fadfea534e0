// Host only: the kind "brute", which builds nothing.
#pragma once
#include "kernels/accel/kind.h"

namespace raywalk::brute {

const Kind& kind();

}  // namespace raywalk::brute
