// GPU only: what all kernel files share. They are compiled at run time, once for each combination of
//   RW_TRAVERSAL  a type of kernels/accel/traversals.h     RW_INTERSECTOR, RW_SLAB, RW_SPAWN  types of kernels/knobs.h
//   RW_FEATURES   bits of kernels/features.h               RW_MODE           a value of Mode
//   RW_BLOCK      threads a block, a multiple of 32        RW_STACK_ENTRIES  of a short stack
//   RW_REGISTERS  cap a thread; 0: the compiler's choice                     RW_NODES  a type of kernels/knobs.h
// A thread is one pixel or one ray. Pixels are numbered block by block (kBlockSide squared), Morton order inside.
#pragma once
#include "kernels/accel/traversals.h"
#include "kernels/frame_request.h"
#include "kernels/tracer.h"

#if RW_REGISTERS
#define RW_KERNEL extern "C" __global__ void __maxnreg__(RW_REGISTERS)
#else
#define RW_KERNEL extern "C" __global__ void __launch_bounds__(RW_BLOCK)
#endif

namespace raywalk {

using KernelKnobs = TraceKnobs<RW_INTERSECTOR, RW_SLAB, RW_NODES>;

template <class Traversal, class CounterT, bool kSingle = Traversal::kGroup == 1>
struct TracerOf {
  using Type = SingleTracer<Traversal, CounterT, KernelKnobs>;
};
template <class Traversal, class CounterT>
struct TracerOf<Traversal, CounterT, false> {
  using Type = GroupTracer<Traversal, CounterT, KernelKnobs>;
};

RW_FN u64 thread_number() {
  return u64{blockIdx.x} * RW_BLOCK + threadIdx.x;
}

struct Pixel {
  u32 x, y;
  bool inside;
};

/// The pixel of a thread number.
RW_FN Pixel pixel_of(const FrameArgs& args, u64 thread) {
  const u32 across = (args.width + kBlockSide - 1) / kBlockSide;
  const u32 block = static_cast<u32>(thread / kBlockRays), lane = static_cast<u32>(thread % kBlockRays);
  const u32 x = block % across * kBlockSide + block_x(lane), y = block / across * kBlockSide + block_y(lane);
  return {x, y, x < args.width && y < args.height};
}

}  // namespace raywalk
