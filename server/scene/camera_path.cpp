// Evaluation of orbits, centripetal Catmull-Rom splines and keyframed cameras.
#include "server/scene/camera_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raywalk {
namespace {

constexpr Vec3 kUp{0.0f, 1.0f, 0.0f};
constexpr u32 kSamplesPerSegment = 64;
// A camera that only turns its head still needs time: movement of the target counts at this rate.
constexpr float kTargetWeight = 0.25f;

CameraKey mix(const CameraKey& a, const CameraKey& b, float wa, float wb) {
  return {wa * a.eye + wb * b.eye, wa * a.target + wb * b.target, wa * a.vertical_fov_deg + wb * b.vertical_fov_deg};
}

float distance(const CameraKey& a, const CameraKey& b) {
  return length(b.eye - a.eye) + kTargetWeight * length(b.target - a.target);
}

/// Barry and Goldman's pyramid on four keys; knots are a square root of the distance apart (centripetal).
class Segment {
 public:
  Segment(const std::vector<CameraKey>& keys, size_t i) {
    const size_t last = keys.size() - 1;
    key_[1] = keys[i];
    key_[2] = keys[i + 1];
    // The ends continue straight on.
    key_[0] = i > 0 ? keys[i - 1] : mix(key_[1], key_[2], 2.0f, -1.0f);
    key_[3] = i + 2 <= last ? keys[i + 2] : mix(key_[2], key_[1], 2.0f, -1.0f);
    for (int k = 1; k < 4; ++k) knot_[k] = knot_[k - 1] + std::max(1e-4f, std::sqrt(distance(key_[k - 1], key_[k])));
  }

  /// u in [0, 1] from the second key to the third.
  CameraKey at(float u) const {
    const float t = knot_[1] + u * (knot_[2] - knot_[1]);
    const CameraKey a1 = between(key_[0], key_[1], 0, 1, t);
    const CameraKey a2 = between(key_[1], key_[2], 1, 2, t);
    const CameraKey a3 = between(key_[2], key_[3], 2, 3, t);
    return between(between(a1, a2, 0, 2, t), between(a2, a3, 1, 3, t), 1, 2, t);
  }

 private:
  CameraKey between(const CameraKey& a, const CameraKey& b, int i, int j, float t) const {
    const float w = (t - knot_[i]) / (knot_[j] - knot_[i]);
    return mix(a, b, 1.0f - w, w);
  }

  CameraKey key_[4];
  float knot_[4] = {};
};

/// The point at the fraction `s` of the way along the whole curve.
CameraKey along(const std::vector<CameraKey>& keys, float s) {
  std::vector<Segment> segments;
  for (size_t i = 0; i + 1 < keys.size(); ++i) segments.emplace_back(keys, i);
  const auto sample = [&](size_t k) {
    const size_t i = std::min(k / kSamplesPerSegment, segments.size() - 1);
    return segments[i].at(static_cast<float>(k - i * kSamplesPerSegment) / kSamplesPerSegment);
  };

  std::vector<float> travelled{0.0f};
  CameraKey previous = keys.front();
  for (size_t k = 1; k <= segments.size() * kSamplesPerSegment; ++k) {
    const CameraKey next = sample(k);
    travelled.push_back(travelled.back() + distance(previous, next));
    previous = next;
  }

  const float wanted = s * travelled.back();
  const size_t after =
      static_cast<size_t>(std::lower_bound(travelled.begin(), travelled.end(), wanted) - travelled.begin());
  if (after == 0) return keys.front();
  if (after >= travelled.size()) return keys.back();
  const float step = travelled[after] - travelled[after - 1];
  const float w = step > 0.0f ? (wanted - travelled[after - 1]) / step : 1.0f;
  return mix(sample(after - 1), sample(after), 1.0f - w, w);
}

CameraPose pose_on(const OrbitPath& orbit, u32 frame, u32 frame_count) {
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  const double azimuth = (orbit.start_deg + 360.0 * orbit.turns * frame / frame_count) * kRadians;
  const double elevation = orbit.elevation_deg * kRadians;
  const Vec3 direction = {static_cast<float>(std::cos(elevation) * std::sin(azimuth)),
                          static_cast<float>(std::sin(elevation)),
                          static_cast<float>(std::cos(elevation) * std::cos(azimuth))};
  return {orbit.centre + orbit.radius * direction, orbit.centre, kUp, orbit.vertical_fov_deg};
}

CameraPose pose_on(const SplinePath& spline, u32 frame, u32 frame_count) {
  if (spline.keys.size() < 2) throw std::invalid_argument("a spline camera path needs at least two keys");
  const float s = frame_count > 1 ? static_cast<float>(frame) / static_cast<float>(frame_count - 1) : 0.0f;
  const CameraKey key = along(spline.keys, s);
  return {key.eye, key.target, spline.up, key.vertical_fov_deg};
}

Vec3 narrow(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

CameraPose pose_on(const KeyframedPath& path, u32 frame, u32 frame_count) {
  const double s = frame_count > 1 ? static_cast<double>(frame) / (frame_count - 1) : 0.0;
  const double time = path.start + (path.end - path.start) * s;
  const glm::dvec3 eye = path.position.at(time);
  const glm::dmat3 rotation = glm::mat3_cast(path.rotation.at(time));
  // A target as far away as the origin keeps its direction when the coordinates are rounded.
  const glm::dvec3 target = eye - std::max(1.0, glm::length(eye)) * rotation[2];
  return {narrow(eye), narrow(target), narrow(rotation[1]), path.vertical_fov_deg};
}

}  // namespace

CameraPose pose_at(const CameraPath& path, u32 frame, u32 frame_count) {
  if (frame >= frame_count) {
    throw std::invalid_argument("frame " + std::to_string(frame) + " of a path of " + std::to_string(frame_count));
  }
  return std::visit([&](const auto& shape) { return pose_on(shape, frame, frame_count); }, path.shape);
}

CameraPath orbit_around(const Box& bounds) {
  const Box box = bounds.empty() ? Box{{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}} : bounds;
  const float radius = 1.1f * length(box.extent());
  // A single point has no extent; any distance shows as much of it.
  return {OrbitPath{box.centre(), radius > 0.0f ? radius : 1.0f, 15.0f, 0.0f, 1.0f, 45.0f}, 400};
}

}  // namespace raywalk
