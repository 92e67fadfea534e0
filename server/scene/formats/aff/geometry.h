// Triangles on their way into the scene: through the fixed transforms at once, through keyframed ones at the end, when
// all keyframes are known.
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "server/scene/formats/aff/keyframes.h"
#include "server/scene/scene_builder.h"

namespace raywalk::aff {

/// A point with its normal (zero: none) as the file has them.
struct Corner {
  glm::dvec3 position;
  glm::dvec3 normal{0.0};
  TexCoord texcoord{};
};

/// An affine transform of points and normals.
class Placement {
 public:
  Placement() : Placement(glm::dmat4(1.0)) {}
  explicit Placement(const glm::dmat4& matrix);

  const glm::dmat4& matrix() const { return matrix_; }
  /// Throws std::runtime_error if it is beyond all floats.
  Vec3 point(const glm::dvec3& p) const;
  /// Unit length; zero stays zero.
  Vec3 normal(const glm::dvec3& n) const;
  MeshCorner corner(const Corner& c) const { return {point(c.position), normal(c.normal), c.texcoord}; }

 private:
  glm::dmat4 matrix_;
  glm::dmat3 normals_;
  bool identity_;
};

class Geometry {
 public:
  explicit Geometry(SceneBuilder& builder) : builder_(builder) {}

  /// A block with a fixed transform, or one that the keyframes of `name` move; `place` is where it begins.
  /// Throws std::runtime_error when they nest too deeply or are too many.
  void open(const glm::dmat4& transform);
  void open(std::string_view name, const std::string& place);
  void close();
  size_t depth() const { return open_.size(); }

  u32 add_vertex(const Corner& corner) { return builder_.add_vertex(placement_.corner(corner)); }
  void add_triangle(u32 a, u32 b, u32 c, u32 material) { builder_.add_triangle({a, b, c, material}); }
  void add_polygon(std::span<const Corner> corners, u32 material);
  void add_light(const glm::dvec3& position, Vec3 intensity);

  using KeyframesOfName = std::map<std::string, Keyframes, std::less<>>;
  /// Moves everything to where it is at `time` and leaves out what is invisible then.
  /// Blocks without keyframes stay where they are, with a warning.
  void settle(const KeyframesOfName& keyframes, double time);

 private:
  /// Everything inside one keyframed block, or outside all (the first).
  struct Node {
    u32 parent;
    glm::dmat4 fixed;  // from the node to its parent, without the keyframes
    std::string name, place;
    Placement placement{};  // to the world, once settled
    bool visible = true;

    /// Throws Error if it is beyond all floats there.
    Vec3 point(Vec3 p) const;
  };
  /// Vertices and triangles from these on belong to a node.
  struct Run {
    size_t first_vertex, first_triangle;
    u32 node;
  };
  struct Block {
    glm::dmat4 outer;
    u32 outer_node;
  };
  void push();
  void begin_run(u32 node);
  void settle_nodes(const KeyframesOfName& keyframes, double time);
  void settle_triangles();
  void settle_lights();

  SceneBuilder& builder_;
  std::vector<Block> open_;
  Placement placement_;  // from here to the current node
  u32 node_ = 0;
  std::vector<Node> nodes_{{0, glm::dmat4(1.0), {}, {}}};
  std::vector<Run> runs_{{0, 0, 0}};
  std::vector<u32> node_of_light_;
  std::vector<MeshCorner> corners_;
};

}  // namespace raywalk::aff
