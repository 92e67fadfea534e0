// Which triangles meet in a point.
#pragma once
#include <vector>

#include "kernels/scene_view.h"

namespace raywalk::accuracy {

/// Over the vertices of a scene by their position, whatever the indices say.
class VertexFans {
 public:
  explicit VertexFans(SceneView scene);
  /// True when all triangles around `p` show clearly the same side to a ray of direction `d`: the surface does not turn
  /// back there as at a silhouette.
  bool face_alike(Vec3 p, Vec3 d) const;

 private:
  SceneView scene_;
  std::vector<u32> corners_;  // triangle * 3 + corner, by position

  Vec3 position(u32 corner) const;
};

}  // namespace raywalk::accuracy
