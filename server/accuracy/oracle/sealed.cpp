// The triangles around a ray, seen along it: coverage is asked for at a point on either side of each edge.
#include "server/accuracy/oracle/sealed.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "server/accuracy/oracle/exact.h"

namespace raywalk::oracle {
namespace {

constexpr double kReach = 2.0;          // radii; what is joined farther away does not matter
constexpr double kAside = 0x1p-10;      // radii from an edge to the points beside it
constexpr double kTolerance = 0x1p-18;  // radii; projected coordinates err by 2^-30

struct Point {
  double x, y;
};
Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
Point operator*(Point a, double s) {
  return {a.x * s, a.y * s};
}
double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}

/// A triangle seen along the ray, which is the origin here; the unit is the radius.
struct Shadow {
  u32 id;
  Point corner[3];
};

/// A plane across the ray.
class Screen {
 public:
  Screen(const Ray& ray, double radius) : o_(ray.o) {
    const Double3 d = to_double(ray.d);
    const Double3 unit = d * (1.0 / length(d)), m = magnitude(unit);
    const Double3 aside = m.x <= m.y && m.x <= m.z ? Double3{1, 0, 0}
                          : m.y <= m.z             ? Double3{0, 1, 0}
                                                   : Double3{0, 0, 1};
    const Double3 right = cross(unit, aside);
    x_ = right * (1.0 / (length(right) * radius));
    y_ = cross(unit, right) * (1.0 / (length(right) * radius));
  }
  Shadow shadow_of(u32 id, const Corners& triangle) const {
    return {id, {point_of(triangle.a), point_of(triangle.b), point_of(triangle.c)}};
  }

 private:
  Vec3 o_;
  Double3 x_, y_;

  Point point_of(Vec3 p) const {
    const Double3 seen = between(o_, p);
    return {dot(seen, x_), dot(seen, y_)};
  }
};

/// The part of the segment pq, from 0 to 1, within `radius` of the origin; empty when first > last.
struct Part {
  double first, last;
};
Part part_within(Point p, Point q, double radius) {
  const Point pq = q - p;
  const double squared_length = dot(pq, pq);
  if (squared_length == 0.0) return dot(p, p) <= radius * radius ? Part{0.0, 0.0} : Part{1.0, 0.0};
  const double closest = -dot(p, pq) / squared_length, distance = cross(p, pq);
  const double half_squared = (radius * radius - distance * distance / squared_length) / squared_length;
  if (half_squared < 0.0) return {1.0, 0.0};
  const double half = std::sqrt(half_squared);
  return {std::max(closest - half, 0.0), std::min(closest + half, 1.0)};
}
bool passes_within(Point p, Point q, double radius) {
  const Part part = part_within(p, q, radius);
  return part.first <= part.last;
}

/// Twice the area over the longest side; the sign is that of the winding.
double width_of(const Shadow& s) {
  const Point ab = s.corner[1] - s.corner[0], bc = s.corner[2] - s.corner[1], ca = s.corner[0] - s.corner[2];
  const double longest = std::sqrt(std::max({dot(ab, ab), dot(bc, bc), dot(ca, ca)}));
  return longest > 0.0 ? cross(ab, bc) / longest : 0.0;
}

/// Seen from its edge, or degenerate, a triangle covers nothing.
bool is_thin(const Shadow& shadow) {
  return std::abs(width_of(shadow)) <= kTolerance;
}

bool covers(const Shadow& shadow, Point p) {
  if (is_thin(shadow)) return false;
  const double winding = width_of(shadow) < 0.0 ? -1.0 : 1.0;
  for (u32 i = 0; i < 3; ++i) {
    const Point from = shadow.corner[i], side = shadow.corner[(i + 1) % 3] - from;
    if (winding * cross(side, p - from) < -kTolerance * std::sqrt(dot(side, side))) return false;
  }
  return true;
}

/// By a shared vertex or edge near the ray.
bool are_joined(const Shadow& s, const Corners& a, const Corners& b) {
  const Vec3 first[3] = {a.a, a.b, a.c}, second[3] = {b.a, b.b, b.c};
  bool shared[3];
  for (u32 i = 0; i < 3; ++i) shared[i] = first[i] == second[0] || first[i] == second[1] || first[i] == second[2];
  for (u32 i = 0; i < 3; ++i) {
    const u32 j = (i + 1) % 3;
    if (shared[i] && dot(s.corner[i], s.corner[i]) <= kReach * kReach) return true;
    if (shared[i] && shared[j] && passes_within(s.corner[i], s.corner[j], kReach)) return true;
  }
  return false;
}

/// True when another triangle has the edge from corner `i` of the shadow on and lies on its other side, or is thin.
bool goes_on_across(const Shadow& shadow, u32 i, const std::vector<Shadow>& surface, SceneView scene) {
  const auto vertices_of = [&](u32 id) {
    const Corners& t = scene.corners()[id];
    return std::array{t.a, t.b, t.c};
  };
  const std::array<Vec3, 3> own = vertices_of(shadow.id);
  const u32 j = (i + 1) % 3;
  const Point from = shadow.corner[i], side = shadow.corner[j] - from;
  const double own_side = cross(side, shadow.corner[(i + 2) % 3] - from);
  return std::any_of(surface.begin(), surface.end(), [&](const Shadow& other) {
    const std::array<Vec3, 3> its = vertices_of(other.id);
    const auto has = [&its](Vec3 p) { return std::find(its.begin(), its.end(), p) != its.end(); };
    if (other.id == shadow.id || !has(own[i]) || !has(own[j])) return false;
    for (u32 k = 0; k < 3; ++k) {
      if (its[k] == own[i] || its[k] == own[j]) continue;
      return is_thin(other) || cross(side, other.corner[k] - from) * own_side < 0.0;
    }
    return false;
  });
}

/// The shadow of `id` and those joined to it.
std::vector<Shadow> joined_to(u32 id, std::vector<Shadow> around, SceneView scene) {
  const auto start = std::find_if(around.begin(), around.end(), [id](const Shadow& s) { return s.id == id; });
  std::vector<Shadow> joined;
  if (start == around.end()) return joined;
  joined.push_back(*start);
  around.erase(start);
  for (u32 i = 0; i < joined.size(); ++i) {
    const Shadow member = joined[i];
    const auto rest = std::partition(around.begin(), around.end(), [&](const Shadow& s) {
      return !are_joined(member, scene.corners()[member.id], scene.corners()[s.id]);
    });
    joined.insert(joined.end(), rest, around.end());
    around.erase(rest, around.end());
  }
  return joined;
}

}  // namespace

bool is_sealed(const Ray& ray, u32 id, double radius, double end, SceneView scene, const BeamTree& tree) {
  const Screen screen(ray, radius);
  std::vector<Shadow> around;
  const auto add = [&](u32 number) {
    const Corners& triangle = scene.corners()[number];
    const Crossing crossing = classify(ray, triangle);
    if (!crossing.touched() || crossing.high < end) around.push_back(screen.shadow_of(number, triangle));
  };
  tree.walk(ray, 0x1p-30, kReach * radius, add, [&ray] { return double{ray.tmax}; });
  const std::vector<Shadow> surface = joined_to(id, std::move(around), scene);
  const auto is_covered = [&surface](Point p) {
    return std::any_of(surface.begin(), surface.end(), [p](const Shadow& s) { return covers(s, p); });
  };
  bool any_edge = false;
  for (const Shadow& shadow : surface) {
    if (is_thin(shadow)) continue;
    for (u32 i = 0; i < 3; ++i) {
      const Point from = shadow.corner[i], side = shadow.corner[(i + 1) % 3] - from;
      const Part part = part_within(from, shadow.corner[(i + 1) % 3], 1.0);
      if (part.first > part.last) continue;
      any_edge = true;
      if (!goes_on_across(shadow, i, surface, scene)) return false;
      const Point middle = from + side * (0.5 * (part.first + part.last));
      const Point aside = Point{-side.y, side.x} * (kAside / std::sqrt(dot(side, side)));
      if (!is_covered(middle + aside) || !is_covered(middle - aside)) return false;
    }
  }
  return any_edge;
}

}  // namespace raywalk::oracle
