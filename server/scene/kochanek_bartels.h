// Splines through keys with tension, continuity and bias, of positions and of rotations.
// D. Kochanek and R. Bartels, "Interpolating Splines with Local Tension, Continuity, and Bias Control", SIGGRAPH 1984.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace raywalk {

template <class Value>
struct SplineKey {
  double time;
  Value value;
  double tension = 0.0, continuity = 0.0, bias = 0.0;
};

/// The curve passes through every key but the first and the last, which only shape its ends.
template <class Value>
class KochanekBartels {
 public:
  /// Throws std::invalid_argument if there are fewer than four keys or a time is before the one ahead of it.
  explicit KochanekBartels(std::vector<SplineKey<Value>> keys);
  /// The same value at all times.
  static KochanekBartels still(const Value& value);

  /// The value at any time: before the second key its value, behind the last but one that one's.
  Value at(double time) const;

 private:
  std::vector<SplineKey<Value>> keys_;
  std::vector<Value> given_;  // the values before any was turned the shorter way
};

using PositionSpline = KochanekBartels<glm::dvec3>;
/// Of quaternions; between neighbouring keys it turns the shorter way. Nothing is normalised.
using RotationSpline = KochanekBartels<glm::dquat>;

}  // namespace raywalk
