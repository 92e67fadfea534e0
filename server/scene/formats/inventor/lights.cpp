// Lights and cameras. Directional lights become point lights far away; the cone of a spot light is not kept.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "server/scene/formats/inventor/interpreter.h"

namespace raywalk {
namespace {

using glm::dvec3;

constexpr u32 kMostLights = 256;
constexpr double kFarAway = 100.0;  // diagonals of the scene's bounds

Vec3 to_float(dvec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Vec3 intensity_of(const IvFields& f) {
  return to_float(glm::max(f.vector("color", dvec3(1.0)), dvec3(0.0)) * std::max(f.number("intensity", 1.0), 0.0));
}

}  // namespace

void IvInterpreter::add_light(const IvFields& f, const Light& light) {
  if (lights_ == kMostLights) return warn_once(f, "lights beyond the first 256 are left out");
  if (!is_finite(light.position) || !is_finite(light.intensity)) throw std::runtime_error("the light is not finite");
  ++lights_;
  builder_.add_light(light);
}

void IvInterpreter::point_light(const IvFields& f) {
  if (!f.flag("on", true)) return;
  const dvec3 position(state_.transform * glm::dvec4(f.vector("location", {0, 0, 1}), 1.0));
  add_light(f, {to_float(position), intensity_of(f)});
}

void IvInterpreter::directional_light(const IvFields& f) {
  if (!f.flag("on", true)) return;
  const dvec3 direction(state_.transform * glm::dvec4(f.vector("direction", {0, 0, -1}), 0.0));
  if (!std::isnormal(glm::length(direction))) return warn_once(f, "a light without a direction is left out");
  if (lights_ == kMostLights) return warn_once(f, "lights beyond the first 256 are left out");
  ++lights_;
  directional_.push_back({glm::normalize(direction), intensity_of(f)});
}

void IvInterpreter::place_directional_lights() {
  const Box box = bounds_of(builder_.scene());
  const dvec3 lo(box.lo.x, box.lo.y, box.lo.z), hi(box.hi.x, box.hi.y, box.hi.z);
  const dvec3 centre = box.empty() ? dvec3(0.0) : 0.5 * (lo + hi);
  const double diagonal = box.empty() ? 1.0 : std::max(glm::length(hi - lo), 1e-6);
  for (const DirectionalLight& light : directional_) {
    const Vec3 position = to_float(centre - kFarAway * diagonal * light.direction);
    if (is_finite(position) && is_finite(light.intensity)) builder_.add_light({position, light.intensity});
  }
}

void IvInterpreter::perspective_camera(const IvFields& f) {
  add_camera(f, f.number("heightAngle", std::numbers::pi / 4));
}

void IvInterpreter::orthographic_camera(const IvFields& f) {
  // The perspective that shows as much at the focal distance.
  add_camera(f, 2.0 * std::atan2(0.5 * f.number("height", 2.0), f.number("focalDistance", 5.0)));
}

void IvInterpreter::add_camera(const IvFields& f, double height_angle) {
  const double degrees = height_angle * 180.0 / std::numbers::pi;
  if (!(degrees >= 1.0 && degrees <= 179.0)) return warn_once(f, "a camera of no usable angle is left out");
  const glm::dvec4 turned = f.rotation("orientation");
  const dvec3 axis(turned);
  const double length = glm::length(axis);
  const auto to_world = [&](dvec3 v) {
    if (length > 0.0) {
      const dvec3 k = axis / length;  // Rodrigues
      v = v * std::cos(turned.w) + glm::cross(k, v) * std::sin(turned.w) +
          k * (glm::dot(k, v) * (1.0 - std::cos(turned.w)));
    }
    return dvec3(state_.transform * glm::dvec4(v, 0.0));
  };
  const dvec3 eye(state_.transform * glm::dvec4(f.vector("position", {0, 0, 1}), 1.0));
  const dvec3 forward = to_world({0, 0, -1}), up = to_world({0, 1, 0});
  const bool usable = std::isnormal(glm::length(forward)) && std::isnormal(glm::length(glm::cross(forward, up)));
  if (!usable) return warn_once(f, "a camera that looks nowhere is left out");
  const dvec3 target = eye + std::max(f.number("focalDistance", 5.0), 1e-3) * glm::normalize(forward);
  NamedCamera camera;
  const size_t count = builder_.scene().cameras.size();
  camera.name = f.node().name.empty() ? "camera " + std::to_string(count + 1) : std::string(f.node().name);
  camera.pose = {to_float(eye), to_float(target), to_float(glm::normalize(up)), static_cast<float>(degrees)};
  if (!is_finite(camera.pose.eye) || !is_finite(camera.pose.target) || camera.pose.eye == camera.pose.target) {
    return warn_once(f, "a camera that looks nowhere is left out");
  }
  builder_.add_camera(std::move(camera));
}

}  // namespace raywalk
