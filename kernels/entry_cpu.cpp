// Shades frames with any traversal, and makes the table of them.
#include "kernels/entry_cpu.h"

#include "kernels/entry_trace.h"
#include "kernels/frame_cpu.h"
#include "kernels/shade/spawn.h"

namespace raywalk {
namespace {

/// Those for the target's knobs and for the nodes of its structure.
template <class Traversal>
const TraceTable::Functions& functions_of(const TraceTarget& target) {
  u32 format = 0;
  if constexpr ((Traversal::kKnobs & kKnobSlab) != 0)
    format = header_of<bvh::Header>(static_cast<const u8*>(target.structure)).format;
  return trace_table<Traversal>().functions[format][target.knobs.intersector][target.knobs.slab];
}

/// The rays of a pixel block together, so that a call by pointer costs nothing.
struct BlockTracer {
  static constexpr u32 kLocal = kBlockRays;
  const TraceFunctions& functions;
  const TraceTarget& target;
  Counts counts[kLocal] = {};

  void closest(const Ray* rays, const bool* active, Hit* hits) {
    functions.closest(target, rays, active, kLocal, hits, counts);
  }
  void occluded(const Ray* rays, const bool* active, bool* out) {
    functions.occluded(target, rays, active, kLocal, out, counts);
  }
  bool any(const bool* flags) const {
    bool some = false;
    for (u32 i = 0; i < kLocal; ++i) some |= flags[i];
    return some;
  }
};

/// The tile's colours, with the spawn offset that the knobs name.
template <class Sink>
void shade(BlockTracer& tracer, const FrameArgs& args, Tile tile, Sink sink) {
  u32 row = 0;
#define RW_SHADE(type, name, help) \
  if (tracer.target.knobs.spawn == row++) shade_tile<type>(tracer, tracer.target.scene, args, tile, sink);
  RW_SPAWN_OFFSETS(RW_SHADE)
#undef RW_SHADE
}

template <class Traversal>
void closest(const TraceTarget& target, const Ray* rays, u64 count, Hit* hits) {
  const TraceFunctions& functions = functions_of<Traversal>(target).plain;
  for_groups<kBlockRays>(count, [&](u64 first, const bool* active) {
    functions.closest(target, rays + first, active, kBlockRays, hits + first, nullptr);
  });
}

template <class Traversal>
void occluded(const TraceTarget& target, const Ray* rays, u64 count, u8* out) {
  const TraceFunctions& functions = functions_of<Traversal>(target).plain;
  for_groups<kBlockRays>(count, [&](u64 first, const bool* active) {
    bool flags[kBlockRays];
    functions.occluded(target, rays + first, active, kBlockRays, flags, nullptr);
    for (u64 i = 0; i < kBlockRays && active[i]; ++i) out[first + i] = flags[i];
  });
}

template <class Traversal>
void count_rays(const TraceTarget& target, const Ray* rays, u64 count, Counts* counts) {
  const TraceFunctions& functions = functions_of<Traversal>(target).counting;
  for_groups<kBlockRays>(count, [&](u64 first, const bool* active) {
    Hit hits[kBlockRays];
    Counts work[kBlockRays] = {};
    functions.closest(target, rays + first, active, kBlockRays, hits, work);
    for (u64 i = 0; i < kBlockRays && active[i]; ++i) counts[first + i] = work[i];
  });
}

template <class Traversal>
void frame(const TraceTarget& target, const FrameArgs& args, Tile tile, Vec3* pixels) {
  BlockTracer tracer{functions_of<Traversal>(target).plain, target};
  shade(tracer, args, tile, [&](u32 x, u32 y, Vec3 color) { pixels[u64{y} * args.width + x] = color; });
}

template <class Traversal>
Counts count_frame(const TraceTarget& target, const FrameArgs& args, Tile tile) {
  BlockTracer tracer{functions_of<Traversal>(target).counting, target};
  shade(tracer, args, tile, [](u32, u32, Vec3) {});
  Counts sum{};
  for (const Counts& counts : tracer.counts) sum += counts;
  return sum;
}

}  // namespace

const std::vector<CpuTraversal>& cpu_traversals() {
#define RW_CPU_ROW(type, space, structure, traversal, group, knobs, help) \
  {structure, traversal, help, knobs, closest<type>, occluded<type>, frame<type>, count_frame<type>, count_rays<type>},
  static const std::vector<CpuTraversal> table = {RW_TRAVERSALS(RW_CPU_ROW)};
#undef RW_CPU_ROW
  return table;
}

}  // namespace raywalk
