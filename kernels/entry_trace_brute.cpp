// Compiles the brute-force loop for the CPU.
#include "kernels/entry_trace.h"

namespace raywalk {

RW_DEFINE_TRACE_TABLE(Brute)

}  // namespace raywalk
