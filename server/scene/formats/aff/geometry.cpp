// The tree of keyframed blocks.
#include "server/scene/formats/aff/geometry.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <set>

namespace raywalk::aff {
namespace {

constexpr size_t kMostOpen = 256;
constexpr size_t kMostNodes = 100'000;

Vec3 narrow(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

glm::dvec3 widen(Vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace

Placement::Placement(const glm::dmat4& matrix) : matrix_(matrix), identity_(matrix == glm::dmat4(1.0)) {
  // Cofactors, so that a scale of zero still gives normals.
  const glm::dmat3 m(matrix);
  normals_ = {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
  if (glm::determinant(m) < 0.0) normals_ = -normals_;
}

Vec3 Placement::point(const glm::dvec3& p) const {
  const Vec3 placed = narrow(identity_ ? p : glm::dvec3(matrix_ * glm::dvec4(p, 1.0)));
  if (!is_finite(placed)) throw std::runtime_error("a coordinate beyond all floats");
  return placed;
}

Vec3 Placement::normal(const glm::dvec3& n) const {
  if (n == glm::dvec3(0.0)) return {0, 0, 0};
  const glm::dvec3 placed = identity_ ? n : normals_ * n;
  const double length = glm::length(placed);
  if (!(length > 0.0) || !std::isfinite(length)) return {0, 0, 0};
  return narrow(placed / length);
}

void Geometry::push() {
  if (open_.size() == kMostOpen) {
    throw std::runtime_error("transforms are nested more than " + std::to_string(kMostOpen) + " deep");
  }
  open_.push_back({placement_.matrix(), node_});
}

void Geometry::open(const glm::dmat4& transform) {
  push();
  placement_ = Placement(placement_.matrix() * transform);
}

void Geometry::open(std::string_view name, const std::string& place) {
  push();
  if (nodes_.size() == kMostNodes) {
    throw std::runtime_error("more than " + std::to_string(kMostNodes) + " keyframed blocks");
  }
  nodes_.push_back({node_, placement_.matrix(), std::string(name), place});
  begin_run(static_cast<u32>(nodes_.size() - 1));
  placement_ = Placement();
}

void Geometry::close() {
  if (node_ != open_.back().outer_node) begin_run(open_.back().outer_node);
  placement_ = Placement(open_.back().outer);
  open_.pop_back();
}

void Geometry::begin_run(u32 node) {
  node_ = node;
  const Run run{builder_.scene().positions.size(), builder_.scene().triangles.size(), node};
  if (runs_.back().first_vertex == run.first_vertex && runs_.back().first_triangle == run.first_triangle) {
    runs_.back() = run;
  } else {
    runs_.push_back(run);
  }
}

void Geometry::add_polygon(std::span<const Corner> corners, u32 material) {
  corners_.clear();
  for (const Corner& corner : corners) corners_.push_back(placement_.corner(corner));
  builder_.add_polygon(corners_, material);
}

void Geometry::add_light(const glm::dvec3& position, Vec3 intensity) {
  node_of_light_.push_back(node_);
  builder_.add_light({placement_.point(position), intensity});
}

Vec3 Geometry::Node::point(Vec3 p) const {
  try {
    return placement.point(widen(p));
  } catch (const std::runtime_error& e) {
    throw Error(place + ": " + e.what());
  }
}

void Geometry::settle(const KeyframesOfName& keyframes, double time) {
  settle_nodes(keyframes, time);
  settle_triangles();
  settle_lights();
}

void Geometry::settle_nodes(const KeyframesOfName& keyframes, double time) {
  std::set<std::string_view> unmoved;
  for (size_t i = 1; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    const Node& parent = nodes_[node.parent];
    glm::dmat4 matrix = parent.placement.matrix() * node.fixed;
    node.visible = parent.visible;
    if (const auto found = keyframes.find(node.name); found != keyframes.end()) {
      matrix = matrix * found->second.placement_at(time);
      node.visible = node.visible && found->second.visible_at(time);
    } else if (unmoved.insert(node.name).second) {
      builder_.warn(node.place, "there are no keyframes (k) of " + in_quotes(node.name) + ": it stays where it is");
    }
    node.placement = Placement(matrix);
  }
}

void Geometry::settle_triangles() {
  Scene& scene = builder_.scene();
  runs_.push_back({scene.positions.size(), scene.triangles.size(), 0});
  size_t kept = 0;
  for (size_t r = 0; r + 1 < runs_.size(); ++r) {
    const Node& node = nodes_[runs_[r].node];
    const Run& next = runs_[r + 1];
    for (size_t i = runs_[r].first_vertex; i < next.first_vertex && runs_[r].node != 0; ++i) {
      scene.positions[i] = node.point(scene.positions[i]);
      scene.normals[i] = node.placement.normal(widen(scene.normals[i]));
    }
    for (size_t i = runs_[r].first_triangle; i < next.first_triangle && node.visible; ++i) {
      scene.triangles[kept++] = scene.triangles[i];
    }
  }
  scene.triangles.resize(kept);
}

void Geometry::settle_lights() {
  std::vector<Light>& lights = builder_.scene().lights;
  size_t kept = 0;
  for (size_t i = 0; i < lights.size(); ++i) {
    const Node& node = nodes_[node_of_light_[i]];
    if (node.visible) lights[kept++] = {node.point(lights[i].position), lights[i].intensity};
  }
  lights.resize(kept);
}

}  // namespace raywalk::aff
