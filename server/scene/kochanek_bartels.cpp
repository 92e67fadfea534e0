// Segments between two keys: cubic for positions, spherical and quadrangular for rotations.
#include "server/scene/kochanek_bartels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raywalk {
namespace {

/// Rotation vector (axis times half the angle) of a unit quaternion.
glm::dvec3 log_of(const glm::dquat& q) {
  const glm::dvec3 v(q.x, q.y, q.z);
  const double sine = glm::length(v);
  return sine > 0.0 ? v * (std::atan2(sine, q.w) / sine) : glm::dvec3(0.0);
}

glm::dquat exp_of(const glm::dvec3& v) {
  const double angle = glm::length(v);
  const glm::dvec3 axis = angle > 0.0 ? v * (std::sin(angle) / angle) : glm::dvec3(0.0);
  return {std::cos(angle), axis.x, axis.y, axis.z};
}

/// The great circle from p to q, also where the way from p to -q would be shorter.
glm::dquat slerp(const glm::dquat& p, const glm::dquat& q, double u) {
  const double angle = std::acos(std::clamp(glm::dot(p, q), -1.0, 1.0));
  const double sine = std::sin(angle);
  constexpr double kStraight = 1e-9;  // nothing between them, or all ways are as long
  if (sine < kStraight) return p;
  return p * (std::sin((1.0 - u) * angle) / sine) + q * (std::sin(u * angle) / sine);
}

/// The way from one value to the next.
glm::dvec3 difference(const glm::dvec3& from, const glm::dvec3& to) {
  return to - from;
}
glm::dvec3 difference(const glm::dquat& from, const glm::dquat& to) {
  return log_of(glm::conjugate(from) * to);
}

/// What the fraction u of the way from p to q is, leaving p with `out` and reaching q with `in`.
glm::dvec3 between(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& out, const glm::dvec3& in, double u) {
  const glm::dvec3 d = q - p;
  return p + u * (out + u * (3.0 * d - 2.0 * out - in + u * (out + in - 2.0 * d)));
}
glm::dquat between(const glm::dquat& p, const glm::dquat& q, const glm::dvec3& out, const glm::dvec3& in, double u) {
  const glm::dvec3 d = difference(p, q);
  const glm::dquat a = p * exp_of((out - d) / 2.0), b = q * exp_of((d - in) / 2.0);
  return slerp(slerp(p, q, u), slerp(a, b, u), 2.0 * u * (1.0 - u));
}

/// `k` points to the second of the four keys that shape a segment; `ahead` is the value of the fourth.
template <class Value>
Value on_segment(const SplineKey<Value>* k, const Value& ahead, double time) {
  const SplineKey<Value>&k0 = k[-1], &k1 = k[0], &k2 = k[1], &k3 = k[2];
  const double span = k2.time - k1.time;
  // Keys at uneven times: the speed is one where the segments meet, not the step.
  const double out_scale = span / (k2.time - k0.time) * (1.0 - k1.tension);
  const double in_scale = span / (k3.time - k1.time) * (1.0 - k2.tension);
  const glm::dvec3 d = difference(k1.value, k2.value);
  const glm::dvec3 out = out_scale * ((1.0 + k1.continuity) * (1.0 + k1.bias) * difference(k0.value, k1.value) +
                                      (1.0 - k1.continuity) * (1.0 - k1.bias) * d);
  const glm::dvec3 in = in_scale * ((1.0 - k2.continuity) * (1.0 + k2.bias) * d +
                                    (1.0 + k2.continuity) * (1.0 - k2.bias) * difference(k2.value, ahead));
  return between(k1.value, k2.value, out, in, (time - k1.time) / span);
}

void take_shorter_ways(std::vector<SplineKey<glm::dvec3>>&) {}
void take_shorter_ways(std::vector<SplineKey<glm::dquat>>& keys) {
  for (size_t i = 1; i < keys.size(); ++i) {
    if (glm::dot(keys[i - 1].value, keys[i].value) < 0.0) keys[i].value = -keys[i].value;
  }
}

}  // namespace

template <class Value>
KochanekBartels<Value>::KochanekBartels(std::vector<SplineKey<Value>> keys) : keys_(std::move(keys)) {
  if (keys_.size() < 4) throw std::invalid_argument("a spline needs at least 4 keys");
  for (size_t i = 1; i < keys_.size(); ++i) {
    if (!(keys_[i].time >= keys_[i - 1].time)) throw std::invalid_argument("the times of the keys go back");
  }
  for (const SplineKey<Value>& key : keys_) given_.push_back(key.value);
  take_shorter_ways(keys_);
}

template <class Value>
KochanekBartels<Value> KochanekBartels<Value>::still(const Value& value) {
  return KochanekBartels(std::vector(4, SplineKey<Value>{0.0, value}));
}

template <class Value>
Value KochanekBartels<Value>::at(double time) const {
  const auto first = keys_.begin() + 1, last = keys_.end() - 2;
  if (!(time > first->time)) return first->value;
  if (time >= last->time) return last->value;
  const auto next = std::upper_bound(first, last, time, [](double t, const auto& key) { return t < key.time; });
  // The study's animations were made with a player that turns a key when the first segment ends on it, not before:
  // the segment ahead of that one still sees it as it was.
  return on_segment(&*next - 1, given_[static_cast<size_t>(next - keys_.begin()) + 1], time);
}

template class KochanekBartels<glm::dvec3>;
template class KochanekBartels<glm::dquat>;

}  // namespace raywalk
