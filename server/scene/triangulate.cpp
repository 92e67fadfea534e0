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

/// Corners still to be cut, linked in a ring, each with a flag whether it is an ear. Cutting one changes the flags of
/// its two neighbours only, so that all cuts together take time in the square of the corners.
class Ring {
 public:
  explicit Ring(std::vector<Point> flat) : flat_(std::move(flat)), size_(static_cast<u32>(flat_.size())) {
    for (u32 i = 0; i < size_; ++i) {
      next_.push_back(i + 1 == size_ ? 0 : i + 1);
      before_.push_back(i == 0 ? size_ - 1 : i - 1);
    }
    for (u32 i = 0; i < size_; ++i) ears_.push_back(is_ear(i));
  }
  u32 size() const { return size_; }
  u32 next(u32 i) const { return next_[i]; }
  u32 before(u32 i) const { return before_[i]; }

  /// The first ear from corner i on. Without one (a polygon that crosses itself, or is flat) any corner must do.
  u32 ear_from(u32 i) const {
    for (u32 k = 0; k < size_ && !ears_[i]; ++k) i = next_[i];
    return i;
  }
  void cut(u32 i) {
    const u32 a = before_[i], c = next_[i];
    next_[a] = c;
    before_[c] = a;
    --size_;
    ears_[a] = is_ear(a);
    ears_[c] = is_ear(c);
  }

 private:
  /// Corner i turns left, and no other corner lies in its triangle.
  bool is_ear(u32 i) const {
    const u32 first = before_[i], last = next_[i];
    const Point a = flat_[first], b = flat_[i], c = flat_[last];
    if (!(turn(a, b, c) > 0.0)) return false;
    for (u32 k = next_[last]; k != first; k = next_[k]) {
      const Point p = flat_[k];
      // A seam to a hole repeats corners, which may touch the ear.
      if (same(p, a) || same(p, b) || same(p, c)) continue;
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  std::vector<Point> flat_;
  std::vector<u32> next_, before_;
  std::vector<char> ears_;
  u32 size_;
};

}  // namespace

std::vector<u32> triangulate(std::span<const u32> corners, std::span<const Vec3> positions) {
  std::vector<u32> triangles;
  if (corners.size() < 3) return triangles;
  Ring ring(flattened(corners, positions));
  u32 at = 0;
  const auto add = [&](u32 corner) {
    triangles.insert(triangles.end(), {corners[ring.before(corner)], corners[corner], corners[ring.next(corner)]});
  };
  while (ring.size() > 3) {
    at = ring.ear_from(at);
    add(at);
    ring.cut(at);
    at = ring.next(at);
  }
  add(at);
  return triangles;
}

}  // namespace raywalk
