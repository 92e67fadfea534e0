// From a camera pose to the vectors that the ray kernels use.
#pragma once
#include "kernels/shade/camera.h"

namespace raywalk {

/// For width x height square pixels. Throws std::invalid_argument when the pose has no view: non-finite numbers, eye at
/// the target, `up` along the view, a field of view outside (0, 180).
Camera camera_of(const CameraPose& pose, u32 width, u32 height);

}  // namespace raywalk
