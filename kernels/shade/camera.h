// Pinhole camera: pixel centre to primary ray.
#pragma once
#include "kernels/ray.h"

namespace raywalk {

/// The direction through pixel (x, y) is corner + (x + 0.5) * across + (y + 0.5) * down; rows run top down.
struct Camera {
  Vec3 eye;
  Vec3 corner, across, down;
};

/// The view of a pinhole at `eye` towards `target`, `vertical_fov_deg` in (0, 180), for width x height square pixels.
struct CameraPose {
  Vec3 eye{0, 0, 0};
  Vec3 target{0, 0, -1};
  Vec3 up{0, 1, 0};
  float vertical_fov_deg = 45;
};

/// Unit direction, unbounded interval. x and y in pixels.
RW_FN Ray primary_ray(const Camera& camera, u32 x, u32 y) {
  const Vec3 d =
      fma(static_cast<float>(x) + 0.5f, camera.across, fma(static_cast<float>(y) + 0.5f, camera.down, camera.corner));
  return {camera.eye, 0.0f, normalized(d), kMaxFloat};
}

}  // namespace raywalk
