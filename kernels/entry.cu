// GPU entry points, compiled at run time once for each traversal and feature mask:
//   RW_TRAVERSAL  a type of kernels/accel/traversals.h      RW_FEATURES  bits of kernels/features.h
// A block is kBlockRays threads; thread i is lane i of a pixel block, or ray blockIdx.x * kBlockRays + i of a list.
#include "kernels/accel/traversals.h"
#include "kernels/shade/radiance.h"
#include "kernels/tracer.h"

namespace raywalk {

template <class Traversal, class CounterT, bool kSingle = Traversal::kGroup == 1>
struct TracerOf {
  using Type = SingleTracer<Traversal, CounterT>;
};
template <class Traversal, class CounterT>
struct TracerOf<Traversal, CounterT, false> {
  static_assert(Traversal::kGroup == kBlockRays);
  using Type = GroupTracer<Traversal, CounterT>;
};
using EntryTracer = TracerOf<RW_TRAVERSAL, NoCounter>::Type;

}  // namespace raywalk

using namespace raywalk;

extern "C" __global__ void __launch_bounds__(kBlockRays)
    closest(const u8* scene, const u8* structure, const Ray* rays, u64 count, Hit* hits) {
  const u64 i = u64{blockIdx.x} * kBlockRays + threadIdx.x;
  const bool active = i < count;
  Ray ray{};
  if (active) ray = rays[i];
  Hit hit;
  EntryTracer tracer{{scene}, structure};
  tracer.closest(&ray, &active, &hit);
  if (active) hits[i] = hit;
}

extern "C" __global__ void __launch_bounds__(kBlockRays)
    occluded(const u8* scene, const u8* structure, const Ray* rays, u64 count, u8* out) {
  const u64 i = u64{blockIdx.x} * kBlockRays + threadIdx.x;
  const bool active = i < count;
  Ray ray{};
  if (active) ray = rays[i];
  bool found;
  EntryTracer tracer{{scene}, structure};
  tracer.occluded(&ray, &active, &found);
  if (active) out[i] = found;
}

extern "C" __global__ void __launch_bounds__(kBlockRays)
    frame(const u8* scene, const u8* structure, FrameArgs args, Vec3* pixels) {
  const u32 x = blockIdx.x * kBlockSide + block_x(threadIdx.x);
  const u32 y = blockIdx.y * kBlockSide + block_y(threadIdx.x);
  const bool active = x < args.width && y < args.height;
  Vec3 color;
  EntryTracer tracer{{scene}, structure};
  radiance<RW_FEATURES>(tracer, SceneView{scene}, args, &x, &y, &active, &color);
  if (active) pixels[u64{y} * args.width + x] = color;
}
