// The work of a traversal: never part of a timed kernel.
#include "kernels/gpu/launch.h"
#include "kernels/shade/radiance.h"

using namespace raywalk;

namespace {

using CountingTracer = TracerOf<RW_TRAVERSAL, Counter>::Type;

RW_FN const Counts& counts_of(const SingleTracer<RW_TRAVERSAL, Counter, KernelKnobs>& tracer) {
  return tracer.counter.counts;
}
template <class TracerT>
RW_FN const Counts& counts_of(const TracerT& tracer) {
  return tracer.counter[0].counts;
}

}  // namespace

/// Adds the work of all rays of a frame's pixels to `sum`.
RW_KERNEL
count_frame(const u8* scene, const u8* structure, const __grid_constant__ FrameBatch batch, Counts* sum) {
  FrameArgs args = batch.frame(0);
  args.mode = Mode{RW_MODE};
  const Pixel pixel = pixel_of(args, thread_number());
  Vec3 color;
  CountingTracer tracer{{scene}, structure};
  radiance<RW_FEATURES, RW_SPAWN>(tracer, SceneView{scene}, args, &pixel.x, &pixel.y, &pixel.inside, &color);
  const Counts& counts = counts_of(tracer);
  atomicAdd(&sum->rays, counts.rays);
  atomicAdd(&sum->steps, counts.steps);
  atomicAdd(&sum->tests, counts.tests);
}

/// Counts of each single ray (closest hit).
RW_KERNEL
count_rays(const u8* scene, const u8* structure, const Ray* rays, u64 count, Counts* counts) {
  const u64 i = thread_number();
  const bool active = i < count;
  Ray ray{};
  if (active) ray = rays[i];
  Hit hit;
  CountingTracer tracer{{scene}, structure};
  tracer.closest(&ray, &active, &hit);
  if (active) counts[i] = counts_of(tracer);
}
