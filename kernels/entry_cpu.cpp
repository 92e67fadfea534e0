// Instantiates every traversal of the list for the CPU, with all features.
#include "kernels/entry_cpu.h"

#include <type_traits>

#include "kernels/accel/traversals.h"
#include "kernels/frame_cpu.h"
#include "kernels/tracer.h"

namespace raywalk {
namespace {

template <class Traversal, class CounterT>
using Tracer =
    std::conditional_t<Traversal::kGroup == 1, SingleTracer<Traversal, CounterT>, GroupTracer<Traversal, CounterT>>;

template <class Traversal>
void closest(SceneView scene, const void* structure, const Ray* rays, u64 count, Hit* hits) {
  closest_hits(Tracer<Traversal, NoCounter>{scene, static_cast<const u8*>(structure)}, rays, count, hits);
}

template <class Traversal>
void occluded(SceneView scene, const void* structure, const Ray* rays, u64 count, u8* out) {
  any_hits(Tracer<Traversal, NoCounter>{scene, static_cast<const u8*>(structure)}, rays, count, out);
}

template <class Traversal>
void count_rays(SceneView scene, const void* structure, const Ray* rays, u64 count, Counts* counts) {
  constexpr u32 kLocal = Tracer<Traversal, Counter>::kLocal;
  for_groups<kLocal>(count, [&](u64 first, const bool* active) {
    Tracer<Traversal, Counter> tracer{scene, static_cast<const u8*>(structure)};
    Ray group[kLocal]{};
    Hit found[kLocal];
    take<kLocal>(rays + first, active, group);
    tracer.closest(group, active, found);
    for (u32 i = 0; i < kLocal && active[i]; ++i) {
      if constexpr (kLocal == 1) {
        counts[first] = tracer.counter.counts;
      } else {
        counts[first + i] = tracer.counter[i].counts;
      }
    }
  });
}

template <class Traversal>
void frame(SceneView scene, const void* structure, const FrameArgs& args, Tile tile, Vec3* pixels) {
  Tracer<Traversal, NoCounter> tracer{scene, static_cast<const u8*>(structure)};
  shade_tile(tracer, scene, args, tile, [&](u32 x, u32 y, Vec3 color) { pixels[u64{y} * args.width + x] = color; });
}

template <class Traversal>
Counts count_frame(SceneView scene, const void* structure, const FrameArgs& args, Tile tile) {
  Tracer<Traversal, Counter> tracer{scene, static_cast<const u8*>(structure)};
  shade_tile(tracer, scene, args, tile, [](u32, u32, Vec3) {});
  return counts_of(tracer);
}

}  // namespace

const std::vector<CpuTraversal>& cpu_traversals() {
#define RW_CPU_ROW(type, space, structure, traversal, group, help) \
  {structure, traversal, help, closest<type>, occluded<type>, frame<type>, count_frame<type>, count_rays<type>},
  static const std::vector<CpuTraversal> table = {RW_TRAVERSALS(RW_CPU_ROW)};
#undef RW_CPU_ROW
  return table;
}

}  // namespace raywalk
