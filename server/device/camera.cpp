// Builds the image plane of a pinhole camera.
#include "server/device/camera.h"

#include <cmath>
#include <stdexcept>

namespace raywalk {

Camera camera_of(const CameraPose& pose, u32 width, u32 height) {
  if (!is_finite(pose.eye) || !is_finite(pose.target) || !is_finite(pose.up))
    throw std::invalid_argument("camera: eye, target and up must be finite");
  if (!(pose.vertical_fov_deg > 0.0f && pose.vertical_fov_deg < 180.0f))
    throw std::invalid_argument("camera: vertical_fov_deg must be between 0 and 180");
  const Vec3 forward = normalized(pose.target - pose.eye);
  if (!(length(forward) > 0.5f) || !is_finite(forward))
    throw std::invalid_argument("camera: eye and target are the same point or too far apart");
  const Vec3 across = cross(forward, normalized(pose.up));
  if (!(length(across) > 1e-6f)) throw std::invalid_argument("camera: up is zero or along the view direction");
  const Vec3 right = normalized(across);
  const Vec3 up = cross(right, forward);
  const float half_height = std::tan(pose.vertical_fov_deg * 0.5f * 0.017453293f);
  const float pixel = 2.0f * half_height / static_cast<float>(height);
  const float half_width = 0.5f * pixel * static_cast<float>(width);
  return {pose.eye, forward + up * half_height - right * half_width, right * pixel, up * -pixel};
}

}  // namespace raywalk
