// The shadow rays that a frame's primary hits send to the lights, made on the host as the kernels make them.
#pragma once
#include <span>
#include <vector>

#include "kernels/ray.h"
#include "kernels/shade/camera.h"
#include "server/device/device.h"

namespace raywalk {

struct ShadowRays {
  std::vector<Ray> rays;
  std::vector<u32> origins;  // the triangle that each leaves
};

/// Of the pairs of a hit and a light on the lit side of its surface, at most `limit`, evenly spaced over the frame.
/// `hits` are in pixel order; the spawn offset is the one that the job's kernel options name.
ShadowRays shadow_rays(SceneView scene, const FrameJob& job, std::span<const Hit> hits, u64 limit);

}  // namespace raywalk
