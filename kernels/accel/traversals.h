// The one list of traversals; the CPU's table and the GPU's entry points are both made from it.
#pragma once
#include "kernels/accel/brute/traverse.h"
#include "kernels/accel/bvh/packet.h"
#include "kernels/accel/bvh/while_while.h"
#include "kernels/accel/grid/dda.h"
#include "kernels/accel/kdtree/short_stack_2.h"
#include "kernels/accel/kdtree/short_stack_3.h"

// X(type, namespace of traverse(), structure, traversal, rays that run together, knobs that it has, help)
#define RW_TRAVERSALS(X)                                                                                      \
  X(Brute, brute, "brute", "loop", 1, 0, "every triangle for every ray: the oracle")                          \
  X(GridDda, grid::dda, "grid", "dda", 1, 0, "cell by cell (Amanatides and Woo 1987), t from the cell index") \
  X(KdtreeShortStack3, kdtree::short_stack_3, "kdtree", "short-stack-3", 1, kKnobStack,                       \
    "push-down, short stack of (mint, maxt, node), restart (Horn et al. 2007)")                               \
  X(KdtreeShortStack2, kdtree::short_stack_2, "kdtree", "short-stack-2", 1, kKnobStack,                       \
    "push-down, short stack of (maxt, node), restart (Zlatuska and Havran 2010)")                             \
  X(BvhPacket, bvh::packet, "bvh", "packet", 32, kKnobSlab,                                                   \
    "8x4 rays share one stack and vote (Guenther et al. 2007)")                                               \
  X(BvhWhileWhile, bvh::while_while, "bvh", "while-while", 1, kKnobSlab,                                      \
    "each ray for itself, near child first (Aila and Laine 2009)")

namespace raywalk {

/// Knobs that only some traversals have: the ray-box test, the entries of a short stack.
enum : u32 { kKnobSlab = 1, kKnobStack = 2 };

// Each traversal as a type, so that tracers can be templates over it.
#define RW_TRAVERSAL_TYPE(type, space, structure, traversal, group, knobs, help) \
  struct type {                                                                  \
    static constexpr u32 kGroup = group;                                         \
    static constexpr u32 kKnobs = knobs;                                         \
    template <class... Types, class... Args>                                     \
    static RW_FN void traverse(Args&&... args) {                                 \
      space::traverse<Types...>(static_cast<Args&&>(args)...);                   \
    }                                                                            \
  };
RW_TRAVERSALS(RW_TRAVERSAL_TYPE)
#undef RW_TRAVERSAL_TYPE

}  // namespace raywalk
