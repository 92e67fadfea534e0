// MGF's surfaces as triangles, transformed on the way into the scene.
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "server/scene/scene_builder.h"
#include "server/scene/tessellate.h"

namespace raywalk {

struct MgfVertex {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  // zero: none
};

/// Each call adds one surface; it throws std::runtime_error if the surface cannot be, or leads to infinity. All are in
/// the space before the transformation. A negative radius turns a surface inside out.
class MgfGeometry {
 public:
  MgfGeometry(SceneBuilder& builder, const ImportSettings& settings) : builder_(builder), settings_(settings) {}

  void place(const glm::dmat4& matrix);               // from now on; its scale is the same along all axes
  void paint(u32 material) { material_ = material; }  // from now on

  void face(std::span<const MgfVertex> corners);
  void sphere(glm::dvec3 centre, double radius);
  void cone(glm::dvec3 base, double base_radius, glm::dvec3 tip, double tip_radius);  // or cylinder
  void ring(const MgfVertex& centre, double inner_radius, double outer_radius);
  void torus(const MgfVertex& centre, double inner_radius, double outer_radius);
  /// The base faces outwards as it is; a negative length turns the prism inside out.
  void prism(std::span<const MgfVertex> base, double length);

 private:
  MeshCorner corner(glm::dvec3 position, glm::dvec3 normal) const;
  void polygon(std::span<const MgfVertex> corners);
  EmitTriangle emit();

  SceneBuilder& builder_;
  const ImportSettings& settings_;
  glm::dmat4 matrix_{1.0};
  bool mirrors_ = false;
  u32 material_ = 0;
  std::vector<MeshCorner> corners_;
};

}  // namespace raywalk
