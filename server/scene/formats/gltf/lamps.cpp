// Point, spot and directional lights become points; perspective cameras become poses.
#include "server/scene/formats/gltf/lamps.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

namespace raywalk::gltf {
namespace {

Vec3 vec(glm::dvec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// A direction of the node in the world, of unit length; zero if the transform flattens it, or leads to infinity.
glm::dvec3 turned(const glm::dmat4& world, glm::dvec3 direction) {
  const glm::dvec3 d = world * glm::dvec4(direction, 0.0);
  const double length = glm::length(d);
  return length > 0.0 && std::isfinite(length) ? d / length : glm::dvec3(0.0);
}

}  // namespace

void Lamps::add(const tinygltf::Node& node, const glm::dmat4& world, const std::string& part) {
  if (const auto found = node.extensions.find("KHR_lights_punctual"); found != node.extensions.end()) {
    const tinygltf::Value& index = found->second.Get("light");
    const int light = index.IsInt() ? index.GetNumberAsInt() : -1;
    add_light(document_.element(document_.model.lights, light, "light", part), world, part);
  }
  if (node.camera >= 0) add_camera(node, world, part);
}

void Lamps::add_light(const tinygltf::Light& light, const glm::dmat4& world, const std::string& part) {
  const auto component = [&](size_t i) {
    return i < light.color.size() ? static_cast<float>(std::clamp(light.color[i], 0.0, 1.0)) : 1.0f;
  };
  const Lamp lamp{glm::dvec3(world[3]),
                  turned(world, {0, 0, -1}),
                  light.type == "directional",
                  light.intensity,
                  {component(0), component(1), component(2)}};
  if (!(lamp.intensity >= 0.0 && lamp.intensity <= kMaxFloat) || !is_finite(vec(lamp.position))) {
    document_.fail(part, "the light's intensity or position is not finite, or negative");
  }
  if (light.type == "spot") builder_.warn(document_.at(part), "a spot light shines in all directions here");
  lamps_.push_back(lamp);
}

void Lamps::add_camera(const tinygltf::Node& node, const glm::dmat4& world, const std::string& part) {
  const tinygltf::Camera& camera = document_.element(document_.model.cameras, node.camera, "camera", part);
  const double fov_deg = camera.perspective.yfov * 180.0 / std::numbers::pi;
  if (camera.type != "perspective" || !(fov_deg > 0.0 && fov_deg < 180.0)) {
    builder_.warn(document_.at(part), "only perspective cameras are known: this one is left out");
    return;
  }
  const glm::dvec3 eye(world[3]), ahead = turned(world, {0, 0, -1}), up = turned(world, {0, 1, 0});
  const Vec3 target = vec(eye + ahead);
  if (!is_finite(target) || target == vec(eye) || glm::length(glm::cross(ahead, up)) < 1e-6) {
    builder_.warn(document_.at(part), "the camera's transform is degenerate: it is left out");
    return;
  }
  std::string name = !camera.name.empty() ? camera.name : node.name;
  if (name.empty()) name = "camera " + std::to_string(node.camera);
  builder_.add_camera({std::move(name), {vec(eye), target, vec(up), static_cast<float>(fov_deg)}});
}

void Lamps::finish() {
  const Box bounds = bounds_of(builder_.scene());
  const bool empty = bounds.lo.x > bounds.hi.x;
  const glm::dvec3 lo = empty ? glm::dvec3(0.0) : glm::dvec3(bounds.lo.x, bounds.lo.y, bounds.lo.z);
  const glm::dvec3 hi = empty ? glm::dvec3(1.0) : glm::dvec3(bounds.hi.x, bounds.hi.y, bounds.hi.z);
  const glm::dvec3 centre = 0.5 * (lo + hi);
  const double size = std::max(glm::length(hi - lo), 1e-6);
  std::vector<double> strengths;
  double squares = 0.0;
  for (const Lamp& lamp : lamps_) {
    // Near the middle a lamp would outshine all others.
    const double distance = std::max(glm::length(lamp.position - centre), 0.1 * size);
    strengths.push_back(lamp.far ? lamp.intensity : lamp.intensity / (distance * distance));
    squares += strengths.back() * strengths.back();
  }
  for (size_t i = 0; i < lamps_.size(); ++i) {
    const Lamp& lamp = lamps_[i];
    if (!(strengths[i] > 0.0)) continue;
    constexpr double kFar = 100.0;  // in sizes of the scene
    const glm::dvec3 position = lamp.far ? centre - kFar * size * lamp.direction : lamp.position;
    builder_.add_light({vec(position), static_cast<float>(strengths[i] / std::sqrt(squares)) * lamp.colour});
  }
  // glTF has no ambient light; shadows would be black.
  if (!builder_.scene().lights.empty()) builder_.scene().ambient = {0.12f, 0.12f, 0.12f};
}

}  // namespace raywalk::gltf
