// Corners sorted by position.
#include "server/accuracy/sweep/vertex_fans.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "server/accuracy/oracle/double3.h"

namespace raywalk::accuracy {
namespace {

/// Cosine between ray and plane below which a triangle may turn when the arithmetic rounds.
constexpr double kEdgeOn = 1e-3;
constexpr double kAngleSlack = 1e-6;  // radians that the angles of a fan may sum up to beyond a full turn

/// A triangle at one of its vertices.
struct Wedge {
  u32 triangle;
  Vec3 ends[2];  // the other two vertices
  bool has(Vec3 end) const { return ends[0] == end || ends[1] == end; }
  Vec3 other(Vec3 end) const { return ends[ends[0] == end ? 1 : 0]; }
};

Wedge wedge_of(u32 corner, SceneView scene) {
  const Corners& t = scene.corners()[corner / 3];
  const Vec3 vertices[3] = {t.a, t.b, t.c};
  return {corner / 3, {vertices[(corner + 1) % 3], vertices[(corner + 2) % 3]}};
}

/// How directions from a point look along a ray: twice the area between two of them, the angle, the slant.
class Look {
 public:
  Look(Vec3 from, Vec3 along) : from_(from), along_(to_double(along)), length_(length(along_)) {}
  double area(Vec3 a, Vec3 b) const { return dot(along_, cross(to(a), to(b))); }
  double angle(Vec3 a, Vec3 b) const {
    const Double3 p = cross(along_, to(a)), q = cross(along_, to(b));
    return std::atan2(length(cross(p, q)), dot(p, q));
  }
  bool is_edge_on(Vec3 a, Vec3 b) const {
    return std::abs(area(a, b)) < kEdgeOn * length_ * length(cross(to(a), to(b)));
  }

 private:
  Vec3 from_;
  Double3 along_;
  double length_;

  Double3 to(Vec3 p) const { return between(from_, p); }
};

/// `first` and all that are joined to it by spokes which two wedges share.
std::vector<Wedge> joined_to(u32 first, std::vector<Wedge> rest) {
  const std::vector<Wedge> all = rest;
  std::vector<Wedge> joined;
  const auto take = [&](auto from) {
    if (from == rest.end()) return;
    joined.push_back(*from);
    rest.erase(from);
  };
  take(std::ranges::find(rest, first, &Wedge::triangle));
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const Wedge wedge = joined[i];
    for (const Vec3 end : wedge.ends) {
      const auto has_end = [end](const Wedge& other) { return other.has(end); };
      if (std::ranges::count_if(all, has_end) == 2) take(std::ranges::find_if(rest, has_end));
    }
  }
  return joined;
}

/// Two neighbours lie on the same side of their spoke, or one is seen edge-on.
bool turns_back(const std::vector<Wedge>& fan, const Look& look) {
  for (const Wedge& wedge : fan) {
    if (look.is_edge_on(wedge.ends[0], wedge.ends[1])) return true;
    for (const Vec3 end : wedge.ends) {
      for (const Wedge& next : fan) {
        if (next.triangle == wedge.triangle || !next.has(end)) continue;
        if (look.area(end, wedge.other(end)) * look.area(end, next.other(end)) > 0.0) return true;
      }
    }
  }
  return false;
}

bool before(Vec3 a, Vec3 b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

VertexFans::VertexFans(SceneView scene) : scene_(scene) {
  corners_.reserve(3ull * scene.triangle_count());
  for (u32 id = 0; id < scene.triangle_count(); ++id) {
    if (!is_finite(scene.corners()[id])) continue;
    for (u32 k = 0; k < 3; ++k) corners_.push_back(3 * id + k);
  }
  std::ranges::sort(corners_, [this](u32 a, u32 b) { return before(position(a), position(b)); });
}

Vec3 VertexFans::position(u32 corner) const {
  const Corners& t = scene_.corners()[corner / 3];
  return corner % 3 == 0 ? t.a : corner % 3 == 1 ? t.b : t.c;
}

std::span<const u32> VertexFans::corners_at(Vec3 p) const {
  const auto found = std::ranges::equal_range(corners_, p, before, [this](u32 corner) { return position(corner); });
  return {found.begin(), found.end()};
}

bool VertexFans::are_one_surface(Vec3 p, Vec3 d, u32 first, u32 second) const {
  std::vector<Wedge> around;
  for (const u32 corner : corners_at(p)) around.push_back(wedge_of(corner, scene_));
  const std::vector<Wedge> fan = joined_to(first, std::move(around));
  if (std::ranges::find(fan, second, &Wedge::triangle) == fan.end()) return false;
  const Look look(p, d);
  double angle = 0.0;
  for (const Wedge& wedge : fan) angle += look.angle(wedge.ends[0], wedge.ends[1]);
  return angle <= 2.0 * std::numbers::pi + kAngleSlack && !turns_back(fan, look);
}

}  // namespace raywalk::accuracy
