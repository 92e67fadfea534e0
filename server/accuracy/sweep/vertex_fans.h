// Which triangles meet in a point, and which of them are one surface there.
#pragma once
#include <span>
#include <vector>

#include "kernels/scene_view.h"

namespace raywalk::accuracy {

/// Over the vertices of a scene by their position, whatever the indices say.
class VertexFans {
 public:
  explicit VertexFans(SceneView scene);
  /// True when around `p`, a vertex of both, triangle `first` is joined to `second` by edges that two triangles share,
  /// and the surface of all that are so joined, seen along `d`, neither turns back as at a silhouette nor winds round
  /// `p` more than once: a line through `p` passes it once. Separate meshes may touch in a point and cover one another;
  /// where three triangles share an edge no surface goes on.
  bool are_one_surface(Vec3 p, Vec3 d, u32 first, u32 second) const;

 private:
  SceneView scene_;
  std::vector<u32> corners_;  // triangle * 3 + corner, by position

  Vec3 position(u32 corner) const;
  std::span<const u32> corners_at(Vec3 p) const;
};

}  // namespace raywalk::accuracy
