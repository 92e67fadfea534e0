// What every device does on the host: the order of rays, and the images that follow from primary hits or counts.
#pragma once
#include "kernels/frame_request.h"
#include "kernels/ray.h"
#include "server/device/device.h"

namespace raywalk {

/// The request of one frame as kernels take it. Throws std::invalid_argument when the camera has no view.
FrameArgs frame_args(const FrameJob& job);

/// Rays of a frame with every 8x8 block full, as a GPU numbers them.
inline u64 padded_rays(u32 width, u32 height) {
  const u64 across = (width + kBlockSide - 1) / kBlockSide, down = (height + kBlockSide - 1) / kBlockSide;
  return across * down * kBlockRays;
}

/// Calls visit(x, y, thread) for every pixel in the order in which rays are traced: block by block, Morton order
/// inside. `thread` also counts the places of a block that lie outside the frame.
template <class Visit>
void in_block_order(u32 width, u32 height, Visit visit) {
  u64 thread = 0;
  for (u32 by = 0; by < height; by += kBlockSide)
    for (u32 bx = 0; bx < width; bx += kBlockSide)
      for (u32 i = 0; i < kBlockRays; ++i, ++thread) {
        const u32 x = bx + block_x(i), y = by + block_y(i);
        if (x < width && y < height) visit(x, y, thread);
      }
}

/// Gives `frame` the job's size; its pixels are to be filled in.
void shape_frame(const FrameJob& job, u32 channels, Frame& frame);

/// Output depth, normal or id from the closest hits of the primary rays in pixel order.
void image_of_hits(const FrameJob& job, SceneView scene, std::span<const Hit> hits, Frame& frame);

/// Output steps from the counts of each primary ray: `counts_of(thread)` is called in block order.
template <class CountsOf>
void image_of_steps(const FrameJob& job, CountsOf counts_of, Frame& frame) {
  shape_frame(job, 2, frame);
  in_block_order(job.width, job.height, [&](u32 x, u32 y, u64 thread) {
    const Counts& counts = counts_of(thread);
    float* pixel = frame.pixels.data() + 2 * (u64{y} * job.width + x);
    pixel[0] = static_cast<float>(counts.steps);
    pixel[1] = static_cast<float>(counts.tests);
  });
}

}  // namespace raywalk
