// Compiles the BVH's packets for the CPU.
#include "kernels/entry_trace.h"

namespace raywalk {

RW_DEFINE_TRACE_TABLE(BvhPacket)

}  // namespace raywalk
