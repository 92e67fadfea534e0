// Compiles the grid's traversal for the CPU.
#include "kernels/entry_trace.h"

namespace raywalk {

RW_DEFINE_TRACE_TABLE(GridDda)

}  // namespace raywalk
