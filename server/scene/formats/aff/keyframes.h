// What a `k` statement says: movement, turns, scale and visibility of one name over time.
#pragma once
#include <glm/mat4x4.hpp>
#include <utility>
#include <vector>

#include "server/scene/formats/aff/text.h"
#include "server/scene/kochanek_bartels.h"

namespace raywalk::aff {

struct Keyframes {
  PositionSpline position = PositionSpline::still(glm::dvec3(0.0));
  RotationSpline rotation = RotationSpline::still(glm::dquat(1.0, 0.0, 0.0, 0.0));
  PositionSpline scale = PositionSpline::still(glm::dvec3(1.0));
  std::vector<std::pair<double, bool>> visibility;  // from each time on; empty: always visible

  size_t left_out = 0;  // keys whose times go back

  /// Scaled, then turned, then moved.
  glm::dmat4 placement_at(double time) const;
  bool visible_at(double time) const;
};

/// Reads the group in braces behind the name.
Keyframes read_keyframes(Text& text);

/// A turn by an angle in degrees around an axis of any length; none around an axis without length.
glm::dquat turn(const glm::dvec3& axis, double angle_deg);

/// Scaled, then turned, then moved.
glm::dmat4 placement(const glm::dvec3& position, const glm::dquat& rotation, const glm::dvec3& scale);

}  // namespace raywalk::aff
