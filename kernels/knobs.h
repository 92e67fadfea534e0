// The knobs of a traversal: what trades accuracy for speed. Compiled into a kernel, so that only what is chosen costs.
#pragma once
#include "kernels/platform.h"

// Each list: X(type, name on the wire, help). The first row is the default, and the strict one.

/// Ray-triangle tests, kernels/triangle.
#define RW_INTERSECTORS(X)                                                                                       \
  X(Watertight, "watertight", "sheared, exact signs: no leaks, each edge counts once (Woop et al. 2013, Kahan)") \
  X(MoellerTrumbore, "moeller-trumbore", "the usual fast one, leaks at edges (Moeller and Trumbore 1997)")       \
  X(Exact, "exact", "a filter in float, then double, then exact sums: hit and miss without any error")           \
  X(MoellerTrumboreDouble, "double", "Moeller and Trumbore in double precision")                                 \
  X(BaldwinWeber, "baldwin-weber", "by precomputed transforms (2016), for structures of triangles=transforms")

/// Ray-box tests of the BVH, kernels/accel/slab.h. Grid and kd-tree pad their triangles instead.
#define RW_SLAB_TESTS(X)                                                             \
  X(PaddedSlab, "padded", "boxes padded by a bound on all rounding, once a ray")     \
  X(IzeSlab, "ize", "far side enlarged by 2 ulp, infinities of IEEE 754 (Ize 2013)") \
  X(PlainSlab, "plain", "no allowance for rounding")

/// Nodes of the BVH, kernels/accel/bvh/layout.h: a property of the structure that a traversal is compiled for.
#define RW_NODE_FORMATS(X)                                   \
  X(FloatNodes, "float", "64 bytes, planes are floats")      \
  X(HalfNodes, "half", "32 bytes, planes of half precision") \
  X(ByteNodes, "byte", "32 bytes, planes are bytes in a frame of the node's own")

/// Where rays start that leave a surface, kernels/shade/spawn.h.
#define RW_SPAWN_OFFSETS(X)                                                                              \
  X(ErrorBoundOffset, "error-bound", "beyond the bound of the hit's rounding error (Pharr et al. 2016)") \
  X(IntegerOffset, "integer", "by a number of ulps along the normal (Waechter and Binder 2019)")         \
  X(ConstantOffset, "constant", "1e-4 scene units along the normal")                                     \
  X(NoOffset, "none", "at the point itself")

namespace raywalk {

#define RW_KNOB_TYPE(type, name, help) struct type;
RW_SLAB_TESTS(RW_KNOB_TYPE)
RW_NODE_FORMATS(RW_KNOB_TYPE)
RW_SPAWN_OFFSETS(RW_KNOB_TYPE)
RW_INTERSECTORS(RW_KNOB_TYPE)
#undef RW_KNOB_TYPE

/// What a traversal is compiled with.
template <class IntersectorT, class SlabT, class NodesT = FloatNodes>
struct TraceKnobs {
  using Intersector = IntersectorT;
  using Slab = SlabT;
  using Nodes = NodesT;
};
using StrictKnobs = TraceKnobs<Watertight, PaddedSlab>;

/// Entries of a short stack: what the study had, and the most that there can be.
constexpr u32 kStackEntries = 4, kMaxStackEntries = 16;

}  // namespace raywalk
