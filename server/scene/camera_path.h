// Camera paths of walkthroughs: an orbit around an object, a spline through keys, or an animation of the scene's file.
#pragma once
#include <variant>
#include <vector>

#include "kernels/shade/camera.h"
#include "server/scene/kochanek_bartels.h"

namespace raywalk {

/// A circle around the vertical (y) axis through `centre`, seen from `elevation_deg` above the horizon.
struct OrbitPath {
  Vec3 centre;
  float radius;
  float elevation_deg;
  float start_deg;  // azimuth of frame 0, from +z towards +x
  float turns;
  float vertical_fov_deg;
};

struct CameraKey {
  Vec3 eye;
  Vec3 target;
  float vertical_fov_deg;
};

/// Centripetal Catmull-Rom curve through the keys, at an even speed of the eye; at least two keys.
struct SplinePath {
  std::vector<CameraKey> keys;
  Vec3 up{0, 1, 0};
};

/// A camera with a timetable of its own, from `start` to `end` in the time of its keys; it looks along -z of the
/// rotation, y is up.
struct KeyframedPath {
  double start, end;
  PositionSpline position;
  RotationSpline rotation;
  float vertical_fov_deg;
};

struct CameraPath {
  std::variant<OrbitPath, SplinePath, KeyframedPath> shape;
  u32 frames = 400;  // of the walkthrough as it was designed
};

/// The camera of frame `frame` when the whole path is shown in `frame_count` frames. Frame 0 is the start; an orbit
/// closes (frame `frame_count` would be frame 0 again for whole turns), a spline ends on its last key, an animation at
/// its end. Throws std::invalid_argument if frame >= frame_count or a spline has fewer than two keys.
CameraPose pose_at(const CameraPath& path, u32 frame, u32 frame_count);

/// The orbit for an object of which only the bounds are known; an empty box is taken as the unit box.
CameraPath orbit_around(const Box& bounds);

}  // namespace raywalk
