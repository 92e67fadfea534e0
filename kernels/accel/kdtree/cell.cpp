// Clips a triangle to a cell: Sutherland-Hodgman in double precision, against the cell grown by the padding.
#include "kernels/accel/kdtree/cell.h"

namespace raywalk::kdtree {
namespace {

struct Polygon {
  double points[9][3];
  int count;
};

/// Keeps the part with sign * coordinate <= sign * plane.
void cut(Polygon& polygon, int axis, double plane, double sign) {
  Polygon kept;
  kept.count = 0;
  for (int i = 0; i < polygon.count; ++i) {
    const double* a = polygon.points[i];
    const double* b = polygon.points[i + 1 == polygon.count ? 0 : i + 1];
    const double da = sign * (a[axis] - plane), db = sign * (b[axis] - plane);
    if (da <= 0) std::copy(a, a + 3, kept.points[kept.count++]);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
      const double at = da / (da - db);
      double* p = kept.points[kept.count++];
      for (int k = 0; k < 3; ++k) p[k] = a[k] + at * (b[k] - a[k]);
      p[axis] = plane;
    }
  }
  polygon = kept;
}

}  // namespace

bool clip(const PaddedFrame& frame, const Corners& triangle, const Cell& child, Part& part) {
  const Vec3 corners[3] = {triangle.a, triangle.b, triangle.c};
  const double pad = frame.pad;
  Polygon polygon;
  polygon.count = 3;
  for (int i = 0; i < 3; ++i) {
    for (u32 axis = 0; axis < 3; ++axis) {
      polygon.points[i][axis] = double{corners[i][axis]} - double{frame.centre[axis]};
    }
  }
  const auto range_of = [&](int axis) {
    double lo = polygon.points[0][axis], hi = lo;
    for (int i = 1; i < polygon.count; ++i) {
      lo = std::min(lo, polygon.points[i][axis]);
      hi = std::max(hi, polygon.points[i][axis]);
    }
    return std::pair(lo, hi);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = range_of(axis);
    // A polygon loses at most one corner and gains two a cut, so nine points are enough for six planes.
    if (lo < child.lo[axis] - pad) cut(polygon, axis, child.lo[axis] - pad, -1);
    if (hi > child.hi[axis] + pad) cut(polygon, axis, child.hi[axis] + pad, 1);
    if (polygon.count == 0) return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = range_of(axis);
    float& low = part.bounds.lo[axis];
    float& high = part.bounds.hi[axis];
    low = std::max({low, child.lo[axis], static_cast<float>(lo - pad)});
    high = std::min({high, child.hi[axis], static_cast<float>(hi + pad)});
    if (low > high) return false;
  }
  return true;
}

}  // namespace raywalk::kdtree
