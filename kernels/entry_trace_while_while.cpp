// Compiles the BVH ray by ray for the CPU.
#include "kernels/entry_trace.h"

namespace raywalk {

RW_DEFINE_TRACE_TABLE(BvhWhileWhile)

}  // namespace raywalk
