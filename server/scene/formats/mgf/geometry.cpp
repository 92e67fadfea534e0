// From surfaces to triangles, with four quarters of five steps to a circle.
#include "server/scene/formats/mgf/geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>

namespace raywalk {
namespace {

using glm::dvec3;

constexpr u32 kSlices = 20;

Vec3 narrow(dvec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Of any length, by Newell's rule; its direction is the right-hand normal.
dvec3 normal_of(std::span<const MgfVertex> corners) {
  dvec3 sum(0.0);
  for (size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(corners[i].position - corners[0].position,
                      corners[(i + 1) % corners.size()].position - corners[0].position);
  }
  return sum;
}

void check_radii(double inner, double outer) {
  if (inner * outer < 0.0) throw std::runtime_error("two radii of different signs");
  if (std::abs(inner) >= std::abs(outer)) throw std::runtime_error("the inner radius is not below the outer one");
}

void check_normal(const MgfVertex& centre) {
  if (centre.normal == dvec3(0.0)) throw std::runtime_error("the vertex has no normal");
}

}  // namespace

void MgfGeometry::place(const glm::dmat4& matrix) {
  matrix_ = matrix;
  mirrors_ = glm::determinant(glm::dmat3(matrix)) < 0.0;
}

MeshCorner MgfGeometry::corner(dvec3 position, dvec3 normal) const {
  const Vec3 placed = narrow(dvec3(matrix_ * glm::dvec4(position, 1.0)));
  if (!is_finite(placed)) throw std::runtime_error("a coordinate beyond all floats");
  const dvec3 turned = glm::dmat3(matrix_) * normal;
  const double length = glm::length(turned);
  return {placed, length > 0.0 ? narrow(turned / length) : Vec3{0, 0, 0}, {}};
}

void MgfGeometry::polygon(std::span<const MgfVertex> corners) {
  corners_.clear();
  for (const MgfVertex& vertex : corners) corners_.push_back(corner(vertex.position, vertex.normal));
  if (mirrors_) std::reverse(corners_.begin(), corners_.end());
  builder_.add_polygon(corners_, material_);
}

EmitTriangle MgfGeometry::emit() {
  return [this](const SurfaceSample& a, const SurfaceSample& b, const SurfaceSample& c) {
    const u32 first = builder_.add_vertex(corner(a.position, a.normal));
    const u32 second = builder_.add_vertex(corner(b.position, b.normal));
    const u32 third = builder_.add_vertex(corner(c.position, c.normal));
    builder_.add_triangle({first, mirrors_ ? third : second, mirrors_ ? second : third, material_});
  };
}

void MgfGeometry::face(std::span<const MgfVertex> corners) {
  polygon(corners);
}

void MgfGeometry::sphere(dvec3 centre, double radius) {
  if (radius == 0.0) throw std::runtime_error("a radius of zero");
  tessellate_sphere(centre, radius, settings_.sphere_slices, settings_.sphere_stacks, emit());
}

void MgfGeometry::cone(dvec3 base, double base_radius, dvec3 tip, double tip_radius) {
  if (base_radius * tip_radius < 0.0) throw std::runtime_error("two radii of different signs");
  if (base_radius == 0.0 && tip_radius == 0.0) throw std::runtime_error("a radius of zero");
  if (base == tip) throw std::runtime_error("both ends are one point");
  tessellate_cone(base, base_radius, tip, tip_radius, kSlices, emit());
}

void MgfGeometry::ring(const MgfVertex& centre, double inner_radius, double outer_radius) {
  check_normal(centre);
  check_radii(inner_radius, outer_radius);
  tessellate_ring(centre.position, centre.normal, inner_radius, outer_radius, kSlices, emit());
}

void MgfGeometry::torus(const MgfVertex& centre, double inner_radius, double outer_radius) {
  check_normal(centre);
  check_radii(inner_radius, outer_radius);
  tessellate_torus(centre.position, centre.normal, inner_radius, outer_radius, kSlices, kSlices, emit());
}

void MgfGeometry::prism(std::span<const MgfVertex> base, double length) {
  const dvec3 sum = normal_of(base);
  if (glm::length(sum) == 0.0) throw std::runtime_error("the base of the prism has no area");
  if (length == 0.0) throw std::runtime_error("the prism has no length");
  const dvec3 away = -length * glm::normalize(sum);
  std::vector<MgfVertex> lid(base.begin(), base.end());
  for (MgfVertex& vertex : lid) vertex.normal = dvec3(0.0);
  polygon(lid);
  for (size_t i = 0; i < base.size(); ++i) {
    const MgfVertex &left = base[i], &right = base[(i + 1) % base.size()];
    const MgfVertex side[] = {right, left, {left.position + away, left.normal}, {right.position + away, right.normal}};
    polygon(side);
  }
  std::reverse(lid.begin(), lid.end());
  for (MgfVertex& vertex : lid) vertex.position += away;
  polygon(lid);
}

}  // namespace raywalk
