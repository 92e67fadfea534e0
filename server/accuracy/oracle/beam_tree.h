// A bounding volume hierarchy that finds every triangle which a ray, thickened to a beam, may touch.
#pragma once
#include <vector>

#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk::oracle {

/// Over the finite triangles of a scene, in their own numbers.
class BeamTree {
 public:
  /// Throws std::bad_alloc.
  explicit BeamTree(SceneView scene);

  /// Calls visit(number) for at least each triangle that passes the line of a valid ray, between tmin and limit(),
  /// within `relative` times the largest component of a vertex seen from the origin, or `radius` if that is larger.
  /// limit() may fall during the walk; roughly front to back.
  template <class Visit, class Limit>
  void walk(const Ray& ray, double relative, double radius, Visit&& visit, Limit&& limit) const;

 private:
  struct Node {
    Box box;
    u32 first;  // triangle among order_, or right child; the left child is the next node
    u32 count;  // of triangles; 0 for an inner node
  };
  std::vector<Node> nodes_;
  std::vector<u32> order_;

  friend class BeamTreeBuilder;
};

}  // namespace raywalk::oracle
