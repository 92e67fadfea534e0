// Images that follow from primary hits.
#include "server/device/outputs.h"

#include <limits>

#include "kernels/shade/surface.h"
#include "server/device/camera.h"

namespace raywalk {

FrameArgs frame_args(const FrameJob& job) {
  return {camera_of(job.camera, job.width, job.height), job.width, job.height, job.mode, job.depth, job.lights};
}

void shape_frame(const FrameJob& job, u32 channels, Frame& frame) {
  frame.width = job.width;
  frame.height = job.height;
  frame.channels = channels;
  frame.pixels.resize(u64{job.width} * job.height * channels);
  frame.readback_ms = 0;
}

void image_of_hits(const FrameJob& job, SceneView scene, std::span<const Hit> hits, Frame& frame) {
  shape_frame(job, job.output == Output::normal ? 3 : 1, frame);
  const Camera camera = camera_of(job.camera, job.width, job.height);
  for (u64 i = 0; i < hits.size(); ++i) {
    const Hit& hit = hits[i];
    if (job.output == Output::depth) {
      frame.pixels[i] = hit.id == kMiss ? std::numeric_limits<float>::infinity() : hit.t;
    } else if (job.output == Output::id) {
      frame.pixels[i] = hit.id == kMiss ? -1.0f : static_cast<float>(hit.id);
    } else {
      const Vec3 d = primary_ray(camera, static_cast<u32>(i % job.width), static_cast<u32>(i / job.width)).d;
      const Vec3 n = hit.id == kMiss ? Vec3{0, 0, 0} : surface_at<kFeatureNormals>(scene, hit, d, 0.0f).normal;
      frame.pixels[3 * i] = n.x;
      frame.pixels[3 * i + 1] = n.y;
      frame.pixels[3 * i + 2] = n.z;
    }
  }
}

}  // namespace raywalk
