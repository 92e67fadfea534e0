// A bounding volume hierarchy that finds every triangle which a ray, thickened to a beam, may touch.
#pragma once
#include <algorithm>
#include <vector>

#include "kernels/ray.h"
#include "kernels/scene_view.h"
#include "server/accuracy/oracle/double3.h"

namespace raywalk::oracle {

/// Over the finite triangles of a scene, in their own numbers.
class BeamTree {
 public:
  /// Throws std::bad_alloc.
  explicit BeamTree(SceneView scene);

  /// Calls visit(number) for at least each triangle that the ray, which must be valid, passes between tmin and limit()
  /// within `relative` (2^-30 or more) times the largest component of a vertex seen from the origin, or within
  /// `radius` when that is more. Both ends have room for 4 ulps of a float. Roughly front to back; limit() is asked
  /// again and again, since it may fall meanwhile.
  template <class Visit, class Limit>
  void walk(const Ray& ray, double relative, double radius, Visit&& visit, Limit&& limit) const;

 private:
  struct Node {
    Box box;
    u32 first;  // in order_ for a leaf; the right child of an inner node, whose left one is the next node
    u32 count;  // of triangles; 0 for an inner node
  };
  struct Item {
    Box box;
    u32 number;
  };
  static constexpr u32 kLeafSize = 4;
  static constexpr u32 kMedianDepth = 64;  // from here on nodes are halved by count, which bounds the depth
  static constexpr u32 kMaxDepth = kMedianDepth + 32;

  std::vector<Node> nodes_;
  std::vector<u32> order_;

  void build(Item* first, Item* last, u32 depth);
};

template <class Visit, class Limit>
void BeamTree::walk(const Ray& ray, double relative, double radius, Visit&& visit, Limit&& limit) const {
  if (nodes_.empty()) return;
  const double o[3] = {ray.o.x, ray.o.y, ray.o.z};
  const double d[3] = {ray.d.x, ray.d.y, ray.d.z};
  const double inverse[3] = {1.0 / d[0], 1.0 / d[1], 1.0 / d[2]};  // finite unless d is 0
  const auto room = [](double t) { return 0x1p-21 * std::abs(t) + 0x1p-147; };
  const double start = ray.tmin - room(ray.tmin);

  /// Where the beam enters the box; infinite when it misses it.
  const auto entry = [&](const Box& box) {
    double low[3], high[3], reach = 0.0;
    for (u32 axis = 0; axis < 3; ++axis) {
      low[axis] = box.lo[axis] - o[axis];
      high[axis] = box.hi[axis] - o[axis];
      reach = std::max({reach, -low[axis], high[axis]});
    }
    const double pad = std::max(relative * reach, radius) * (1.0 + 0x1p-10) + 0x1p-45 * reach;
    double enter = start, leave = 1e300;
    for (u32 axis = 0; axis < 3; ++axis) {
      const double from = low[axis] - pad, to = high[axis] + pad;
      if (d[axis] == 0.0) {
        if (from > 0.0 || to < 0.0) return 1e300;
        continue;
      }
      const double s = from * inverse[axis], t = to * inverse[axis];
      enter = std::max(enter, std::min(s, t));
      leave = std::min(leave, std::max(s, t));
    }
    return enter <= leave ? enter : 1e300;
  };

  struct Waiting {
    u32 node;
    double entry;
  };
  Waiting stack[kMaxDepth];
  u32 depth = 0;
  Waiting now{0, entry(nodes_[0].box)};
  while (true) {
    const double end = limit();
    if (now.entry <= end + room(end)) {
      const Node& node = nodes_[now.node];
      if (node.count == 0) {
        Waiting left{now.node + 1, entry(nodes_[now.node + 1].box)};
        Waiting right{node.first, entry(nodes_[node.first].box)};
        if (right.entry < left.entry) std::swap(left, right);
        now = left;
        if (right.entry < 1e300) stack[depth++] = right;
        continue;
      }
      for (u32 i = 0; i < node.count; ++i) visit(order_[node.first + i]);
    }
    if (depth == 0) return;
    now = stack[--depth];
  }
}

}  // namespace raywalk::oracle
