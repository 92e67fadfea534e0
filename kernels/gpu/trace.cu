// Lists of rays: primary rays made, closest hits, any hits.
#include "kernels/gpu/launch.h"

using namespace raywalk;

/// Rays of the frame in the order of `pixel_of`; places of pixels outside the frame get a ray that misses everything.
/// blockIdx.y is the frame of the batch.
RW_KERNEL
primary_rays(const __grid_constant__ FrameBatch batch, u64 rays_per_frame, Ray* rays) {
  const FrameArgs args = batch.frame(blockIdx.y);
  const u64 thread = thread_number();
  if (thread >= rays_per_frame) return;
  const Pixel pixel = pixel_of(args, thread);
  Ray& ray = rays[u64{blockIdx.y} * rays_per_frame + thread];
  ray = pixel.inside ? primary_ray(args.camera, pixel.x, pixel.y) : Ray{};
}

RW_KERNEL
closest(const u8* scene, const u8* structure, const Ray* rays, u64 count, Hit* hits) {
  const u64 i = thread_number();
  const bool active = i < count;
  Ray ray{};
  if (active) ray = rays[i];
  Hit hit;
  TracerOf<RW_TRAVERSAL, NoCounter>::Type tracer{{scene}, structure};
  tracer.closest(&ray, &active, &hit);
  if (active) hits[i] = hit;
}

RW_KERNEL
occluded(const u8* scene, const u8* structure, const Ray* rays, u64 count, u8* out) {
  const u64 i = thread_number();
  const bool active = i < count;
  Ray ray{};
  if (active) ray = rays[i];
  bool found;
  TracerOf<RW_TRAVERSAL, NoCounter>::Type tracer{{scene}, structure};
  tracer.occluded(&ray, &active, &found);
  if (active) out[i] = found;
}
