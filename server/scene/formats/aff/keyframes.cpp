// Reading and evaluating keyframes.
#include "server/scene/formats/aff/keyframes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace raywalk::aff {
namespace {

/// Axes of keys are meant to be of unit length. Those of the BART cameras are a little off and taken as they are.
glm::dquat nearly_unit_turn(const glm::dvec3& axis, double angle_deg) {
  if (std::abs(glm::length(axis) - 1.0) > 0.1) return turn(axis, angle_deg);
  const double half = glm::radians(angle_deg) / 2.0;
  const glm::dvec3 v = std::sin(half) * axis;
  return {std::cos(half), v.x, v.y, v.z};
}

template <class Value, class ReadValue>
KochanekBartels<Value> read_spline(Text& text, size_t numbers_a_value, size_t& left_out, ReadValue read_value) {
  std::vector<SplineKey<Value>> keys;
  for (size_t left = text.count("keys", numbers_a_value + 4); left > 0; --left) {
    SplineKey<Value> key{text.real("time of a key"), {}};
    key.value = read_value();
    key.tension = text.real("tension");
    key.continuity = text.real("continuity");
    key.bias = text.real("bias");
    // The robots of BART have tables that begin anew; the first pass through a time counts.
    if (keys.empty() || key.time >= keys.back().time) {
      keys.push_back(key);
    } else {
      ++left_out;
    }
  }
  try {
    return KochanekBartels<Value>(std::move(keys));
  } catch (const std::invalid_argument& e) {
    text.fail(e.what());
  }
}

PositionSpline read_positions(Text& text, const char* what, size_t& left_out) {
  return read_spline<glm::dvec3>(text, 3, left_out, [&] { return text.point(what); });
}

RotationSpline read_rotations(Text& text, size_t& left_out) {
  return read_spline<glm::dquat>(text, 4, left_out, [&] {
    const glm::dvec3 axis = text.point("axis");
    return nearly_unit_turn(axis, text.real("angle"));
  });
}

std::vector<std::pair<double, bool>> read_visibility(Text& text) {
  std::vector<std::pair<double, bool>> keys(text.count("visibility keys", 2));
  for (size_t i = 0; i < keys.size(); ++i) {
    const double time = text.real("time of a key");
    if (i > 0 && time < keys[i - 1].first) text.fail("the times of the keys go back");
    const long long visible = text.integer("visibility");
    if (visible != 0 && visible != 1) text.fail("visibility is 0 or 1, not " + std::to_string(visible));
    keys[i] = {time, visible == 1};
  }
  return keys;
}

}  // namespace

glm::dquat turn(const glm::dvec3& axis, double angle_deg) {
  const double length = glm::length(axis);
  if (!(length > 0.0)) return {1.0, 0.0, 0.0, 0.0};
  return glm::angleAxis(glm::radians(angle_deg), axis / length);
}

glm::dmat4 placement(const glm::dvec3& position, const glm::dquat& rotation, const glm::dvec3& scale) {
  return glm::scale(glm::translate(glm::dmat4(1.0), position) * glm::mat4_cast(rotation), scale);
}

glm::dmat4 Keyframes::placement_at(double time) const {
  return placement(position.at(time), glm::normalize(rotation.at(time)), scale.at(time));
}

bool Keyframes::visible_at(double time) const {
  if (visibility.empty()) return true;
  bool visible = visibility.front().second;
  for (const auto& [from, value] : visibility) {
    if (from <= time) visible = value;
  }
  return visible;
}

Keyframes read_keyframes(Text& text) {
  Keyframes keyframes;
  text.expect("{");
  for (std::string_view part = text.word(); part != "}"; part = text.word()) {
    if (part == "transl") {
      keyframes.position = read_positions(text, "position", keyframes.left_out);
    } else if (part == "rot") {
      keyframes.rotation = read_rotations(text, keyframes.left_out);
    } else if (part == "scale") {
      keyframes.scale = read_positions(text, "scale", keyframes.left_out);
    } else if (part == "visibility") {
      keyframes.visibility = read_visibility(text);
    } else if (part.empty()) {
      text.fail("the file ends inside keyframes");
    } else {
      text.fail(in_quotes(part) + " is none of transl, rot, scale and visibility");
    }
  }
  return keyframes;
}

}  // namespace raywalk::aff
