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

/// Unit direction through the centre of the pixel at column x, row y.
RW_FN Vec3 primary_direction(const Camera& camera, float x, float y) {
  return normalized(fma(x + 0.5f, camera.across, fma(y + 0.5f, camera.down, camera.corner)));
}

/// Width of a pixel at distance 1.
RW_FN float spread_of(const Camera& camera) {
  return length(camera.down);
}

/// The ray through pixel (x, y), with an unbounded interval.
RW_FN Ray primary_ray(const Camera& camera, u32 x, u32 y) {
  return {camera.eye, 0.0f, primary_direction(camera, static_cast<float>(x), static_cast<float>(y)), kMaxFloat};
}

}  // namespace raywalk
