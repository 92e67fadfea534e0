// Shaded frames. blockIdx.y is the frame of the batch; x covers its pixels.
#include "kernels/gpu/launch.h"
#include "kernels/shade/radiance.h"

using namespace raywalk;

RW_KERNEL
frame(const u8* scene, const u8* structure, const __grid_constant__ FrameBatch batch, Vec3* pixels) {
  FrameArgs args = batch.frame(blockIdx.y);
  args.mode = Mode{RW_MODE};  // known to the compiler
  const Pixel pixel = pixel_of(args, thread_number());
  Vec3 color;
  TracerOf<RW_TRAVERSAL, NoCounter>::Type tracer{{scene}, structure};
  radiance<RW_FEATURES, RW_SPAWN>(tracer, SceneView{scene}, args, &pixel.x, &pixel.y, &pixel.inside, &color);
  if (pixel.inside) pixels[(u64{blockIdx.y} * args.height + pixel.y) * args.width + pixel.x] = color;
}
