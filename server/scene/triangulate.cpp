// Ear clipping in the plane that the polygon's Newell normal favours.
#include "server/scene/triangulate.h"

namespace raywalk {
namespace {

struct Point {
  double x, y;
};

/// Twice the signed area; positive when a, b, c turn left.
double turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool same(Point a, Point b) {
  return a.x == b.x && a.y == b.y;
}

/// Drops the axis along which the polygon has its largest area; the result turns left.
std::vector<Point> flattened(std::span<const u32> corners, std::span<const Vec3> positions) {
  double nx = 0.0, ny = 0.0, nz = 0.0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec3 p = positions[corners[i]];
    const Vec3 q = positions[corners[(i + 1) % corners.size()]];
    nx += (double(p.y) - q.y) * (double(p.z) + q.z);
    ny += (double(p.z) - q.z) * (double(p.x) + q.x);
    nz += (double(p.x) - q.x) * (double(p.y) + q.y);
  }
  const double ax = nx < 0 ? -nx : nx, ay = ny < 0 ? -ny : ny, az = nz < 0 ? -nz : nz;
  std::vector<Point> flat;
  for (const u32 corner : corners) {
    const Vec3 p = positions[corner];
    if (ax >= ay && ax >= az) {
      flat.push_back(nx >= 0 ? Point{p.y, p.z} : Point{p.z, p.y});
    } else if (ay >= az) {
      flat.push_back(ny >= 0 ? Point{p.z, p.x} : Point{p.x, p.z});
    } else {
      flat.push_back(nz >= 0 ? Point{p.x, p.y} : Point{p.y, p.x});
    }
  }
  return flat;
}

/// Corners still to be cut, as a ring of indices into the flat polygon.
class Ring {
 public:
  explicit Ring(std::vector<Point> flat) : flat_(std::move(flat)) {
    for (u32 i = 0; i < flat_.size(); ++i) left_.push_back(i);
  }
  size_t size() const { return left_.size(); }
  u32 at(size_t i) const { return left_[i % left_.size()]; }
  void remove(size_t i) { left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i % left_.size())); }

  /// The corner after position i turns left, and no other corner lies in its triangle.
  bool is_ear(size_t i) const {
    const Point a = flat_[at(i)], b = flat_[at(i + 1)], c = flat_[at(i + 2)];
    if (!(turn(a, b, c) > 0.0)) return false;
    for (size_t k = i + 3; k < i + left_.size(); ++k) {
      const Point p = flat_[at(k)];
      // A seam to a hole repeats corners, which may touch the ear.
      if (same(p, a) || same(p, b) || same(p, c)) continue;
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
  }

 private:
  std::vector<Point> flat_;
  std::vector<u32> left_;
};

}  // namespace

std::vector<u32> triangulate(std::span<const u32> corners, std::span<const Vec3> positions) {
  std::vector<u32> triangles;
  if (corners.size() < 3) return triangles;
  Ring ring(flattened(corners, positions));
  size_t start = 0;
  while (ring.size() > 3) {
    size_t ear = start;
    while (ear < start + ring.size() && !ring.is_ear(ear)) ++ear;
    // Without an ear (a polygon that crosses itself, or is flat) any corner must do.
    triangles.insert(triangles.end(), {corners[ring.at(ear)], corners[ring.at(ear + 1)], corners[ring.at(ear + 2)]});
    const size_t cut = (ear + 1) % ring.size();
    ring.remove(cut);
    start = cut % ring.size();
  }
  triangles.insert(triangles.end(), {corners[ring.at(0)], corners[ring.at(1)], corners[ring.at(2)]});
  return triangles;
}

}  // namespace raywalk
