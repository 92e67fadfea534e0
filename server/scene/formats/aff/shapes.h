// The statements of AFF that make triangles, except meshes.
#pragma once
#include <string_view>
#include <vector>

#include "server/scene/formats/aff/geometry.h"
#include "server/scene/formats/aff/materials.h"

namespace raywalk::aff {

/// Each function reads what follows its word and throws std::runtime_error.
class Shapes {
 public:
  Shapes(Geometry& geometry, Materials& materials, const ImportSettings& settings, double time)
      : geometry_(geometry), materials_(materials), settings_(settings), time_(time) {}

  void read_sphere(Text& text);
  void read_cone(Text& text);
  /// p, and pp with a normal behind each point.
  void read_polygon(Text& text, bool normals);
  /// tt, and ttp with a normal behind each point.
  void read_textured_triangle(Text& text, bool normals);
  /// tpa: a triangle that changes over time, as it is at the time given.
  void read_animated_triangle(Text& text);
  /// Because the settings ask for it.
  u64 cones_left_out() const { return cones_left_out_; }

 private:
  void add_triangle(const Corner (&corners)[3], u32 material);
  template <class Tessellate>
  void add_curved(Tessellate tessellate);

  Geometry& geometry_;
  Materials& materials_;
  const ImportSettings& settings_;
  double time_;
  u64 cones_left_out_ = 0;
  std::vector<Corner> corners_;
};

}  // namespace raywalk::aff
