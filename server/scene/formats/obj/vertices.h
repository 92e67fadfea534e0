// The vertices of an OBJ file: three lists with indices of their own, made into one.
#pragma once
#include "server/scene/scene_builder.h"

namespace raywalk {

class ObjVertices {
 public:
  explicit ObjVertices(SceneBuilder& builder) : builder_(builder) {}

  void add_position(Vec3 position);
  /// Of any length; a zero one is none.
  void add_normal(Vec3 normal) { normals_.push_back(normalized(normal)); }
  /// As OBJ has them: (0, 0) is the lower left corner of the image.
  void add_texcoord(float u, float v) { texcoords_.push_back({u, 1.0f - v}); }

  /// Vertex in the scene of a corner "v", "v/vt", "v//vn" or "v/vt/vn"; equal corners share it where they are found
  /// soon. Throws std::runtime_error if it is no such word, or an index is out of range.
  u32 corner(std::string_view word);

 private:
  static constexpr u32 kNone = 0xffffffffu;
  /// A vertex of the scene, and the next one at the same position.
  struct Used {
    u32 texcoord, normal, next;
  };

  SceneBuilder& builder_;
  std::vector<Vec3> positions_;
  std::vector<Vec3> normals_;
  std::vector<TexCoord> texcoords_;
  std::vector<u32> first_;  // of each position: the last vertex made of it
  std::vector<Used> used_;  // one a vertex of the scene
};

}  // namespace raywalk
