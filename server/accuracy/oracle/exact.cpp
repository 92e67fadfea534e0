// A filter in double, and integers where it cannot tell.
#include "server/accuracy/oracle/exact.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

#include "server/accuracy/oracle/double3.h"
#include "server/accuracy/oracle/integers.h"

namespace raywalk::oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One ray and one triangle, with the integers made when they are first needed.
class Pair {
 public:
  Pair(const Ray& ray, const Corners& triangle)
      : ray_(ray),
        triangle_(triangle),
        d_(to_double(ray.d)),
        corner_{between(ray.o, triangle.a), between(ray.o, triangle.b), between(ray.o, triangle.c)},
        edge_{between(triangle.b, triangle.c), between(triangle.c, triangle.a), between(triangle.a, triangle.b)} {}

  Crossing classify();
  /// To the plane; an infinite error when the filter cannot bound it.
  Bounded distance() const;
  /// The denominator is 0 when the line is parallel to the plane.
  Ratio exact_distance() { return integers().distance(); }

 private:
  const Ray& ray_;
  const Corners& triangle_;
  Double3 d_, corner_[3], edge_[3];  // an edge is opposite to the corner of its number
  Bounded weight_[3];                // edge functions
  std::optional<Integers> integers_;

  const Integers& integers() { return integers_ ? *integers_ : integers_.emplace(ray_, triangle_); }
  Position position();
  bool may_be_near(double radius) const;
  bool is_degenerate();
  void set_distances(Crossing& crossing, const double (&along)[3]);
};

/// The squared distance between the origin and the segment pq.
double squared_distance(Double3 p, Double3 q) {
  const Double3 pq = q - p;
  const double squared_length = dot(pq, pq);
  const double s = squared_length > 0.0 ? std::clamp(-dot(p, pq) / squared_length, 0.0, 1.0) : 0.0;
  const Double3 closest = p + pq * s;
  return dot(closest, closest);
}

Position Pair::position() {
  int sign[3];
  bool known[3];
  for (u32 i = 0; i < 3; ++i) {
    weight_[i] = determinant(d_, corner_[(i + 1) % 3], corner_[(i + 2) % 3]);
    known[i] = weight_[i].has_sign();
    sign[i] = known[i] ? weight_[i].sign() : 0;
  }
  const auto mixed = [&sign] {
    return (sign[0] < 0 || sign[1] < 0 || sign[2] < 0) && (sign[0] > 0 || sign[1] > 0 || sign[2] > 0);
  };
  for (u32 i = 0; i < 3 && !mixed(); ++i) {
    if (!known[i]) sign[i] = integers().edge_sign(i);
  }
  if (mixed()) return Position::outside;
  switch ((sign[0] == 0) + (sign[1] == 0) + (sign[2] == 0)) {
    case 0:
      return Position::inside;
    case 1:
      return Position::edge;
    case 2:
      return Position::vertex;
    default:
      return Position::coplanar;  // the weights add up to d . normal
  }
}

/// False when each edge, made a line, passes farther away: |weight| is that distance times |d x edge|. The factor 2 is
/// for the sum of that product and its rounding.
bool Pair::may_be_near(double radius) const {
  const double d_squared = dot(d_, d_), factor = 2.0 * (1.0 + 0x1p-20) * radius * radius;
  for (u32 i = 0; i < 3; ++i) {
    const double least = std::max(std::abs(weight_[i].value) - weight_[i].error, 0.0);
    const Double3 area = cross(d_, edge_[i]);
    if (least * least <= factor * (dot(area, area) + 0x1p-100 * d_squared * dot(edge_[i], edge_[i]))) return true;
  }
  return false;
}

bool Pair::is_degenerate() {
  const Double3 n = cross(edge_[2], edge_[1]), p = magnitude(edge_[2]), q = magnitude(edge_[1]);
  for (u32 axis = 0; axis < 3; ++axis) {
    const u32 y = (axis + 1) % 3, z = (axis + 2) % 3;
    if (std::abs(n[axis]) > 0x1p-50 * (p[y] * q[z] + p[z] * q[y])) return false;
  }
  return integers().is_degenerate();
}

Bounded Pair::distance() const {
  const Bounded across = determinant(corner_[0], edge_[2], edge_[1]), along = determinant(d_, edge_[2], edge_[1]);
  if (std::abs(along.value) < 4.0 * along.error || along.value == 0.0) return {0.0, kInfinity};
  const double t = across.value / along.value, size = std::abs(t);
  const double error = (across.error + size * along.error) / (std::abs(along.value) - along.error);
  return {t, error * (1.0 + 0x1p-40) + 0x1p-52 * size};
}

/// `along` are the corners' distances along the ray.
void Pair::set_distances(Crossing& crossing, const double (&along)[3]) {
  Bounded t = distance();
  if (crossing.met()) {
    crossing.t = static_cast<float>(t.value);
    const auto least = static_cast<float>(t.value - t.error), most = static_cast<float>(t.value + t.error);
    if (least != most || t.error > 0x1p-12 * ulp_at(t.value)) {
      const Ratio exact = exact_distance();
      crossing.t = to_float(exact);
      t = {to_double(exact), 0.0};
    }
    crossing.t += 0.0f;  // no -0
    crossing.precise_t = t.value;
  }
  // Moved by the radius, the ray meets the plane this much earlier or later, and the triangle within its extent.
  const double step = crossing.radius / length(d_);
  const Double3 normal = cross(edge_[2], edge_[1]);
  const double slope = std::abs(dot(normal, d_));
  const double slack = slope > 0.0 ? crossing.radius * length(normal) / slope : kInfinity;
  const double first = std::min({along[0], along[1], along[2]}) - step;
  const double last = std::max({along[0], along[1], along[2]}) + step;
  const bool crosses = t.error < kInfinity && slack < kInfinity;
  crossing.low = crosses ? std::clamp(t.value - slack, first, last) : first;
  crossing.high = crosses ? std::clamp(t.value + slack, first, last) : last;
  crossing.low -= kTieUlps * ulp_at(crossing.low);
  crossing.high += kTieUlps * ulp_at(crossing.high);
}

Crossing Pair::classify() {
  Crossing result;
  result.position = position();
  result.radius = kNear * largest(Double3{largest(magnitude(corner_[0])), largest(magnitude(corner_[1])),
                                          largest(magnitude(corner_[2]))});
  const bool may_be = result.position == Position::coplanar || may_be_near(result.radius);
  if (may_be || result.met()) {
    const double d_length = length(d_);
    const Double3 unit = d_ * (1.0 / d_length);
    Double3 across[3];
    double along[3];
    for (u32 i = 0; i < 3; ++i) {
      const double h = dot(corner_[i], unit);
      across[i] = corner_[i] - unit * h;
      along[i] = h / d_length;
    }
    const double limit = result.radius * result.radius;
    result.near =
        may_be && (squared_distance(across[1], across[2]) <= limit || squared_distance(across[2], across[0]) <= limit ||
                   squared_distance(across[0], across[1]) <= limit);
    result.near = result.near && (result.met() || !is_degenerate());
    if (result.touched()) set_distances(result, along);
  }
  result.by_integers = integers_.has_value();
  return result;
}

int sign_of(double a) {
  return (a > 0.0) - (a < 0.0);
}

}  // namespace

Crossing classify(const Ray& ray, const Corners& triangle) {
  return is_valid(ray) && is_finite(triangle) ? Pair(ray, triangle).classify() : Crossing{};
}

int compare_distances(const Ray& ray, const Corners& a, const Corners& b) {
  Pair first(ray, a), second(ray, b);
  const Bounded s = first.distance(), t = second.distance();
  if (std::abs(s.value - t.value) > (s.error + t.error) * (1.0 + 0x1p-40)) return sign_of(s.value - t.value);
  return compare(first.exact_distance(), second.exact_distance());
}

int compare_distance(const Ray& ray, const Corners& triangle, float bound) {
  Pair pair(ray, triangle);
  const Bounded t = pair.distance();
  if (std::abs(t.value - bound) > t.error * (1.0 + 0x1p-40)) return sign_of(t.value - bound);
  return compare(pair.exact_distance(), to_ratio(bound));
}

double ulp_at(double t) {
  constexpr u64 kBias = 1023;
  const u64 exponent = std::bit_cast<u64>(std::abs(t)) >> 52;
  return std::bit_cast<double>((std::max(exponent, kBias - 126) - 23) << 52);
}

}  // namespace raywalk::oracle
