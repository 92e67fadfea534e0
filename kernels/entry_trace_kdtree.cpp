// Compiles the kd-tree's traversals for the CPU.
#include "kernels/entry_trace.h"

namespace raywalk {

RW_DEFINE_TRACE_TABLE(KdtreeShortStack3)
RW_DEFINE_TRACE_TABLE(KdtreeShortStack2)

}  // namespace raywalk
