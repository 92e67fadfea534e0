// Spheres, cones, polygons and single triangles.
#include "server/scene/formats/aff/shapes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "server/scene/tessellate.h"

namespace raywalk::aff {

void Shapes::add_triangle(const Corner (&corners)[3], u32 material) {
  const u32 a = geometry_.add_vertex(corners[0]), b = geometry_.add_vertex(corners[1]);
  geometry_.add_triangle(a, b, geometry_.add_vertex(corners[2]), material);
}

/// Triangles that meet in a point and a normal share the vertex.
template <class Tessellate>
void Shapes::add_curved(Tessellate tessellate) {
  const u32 material = materials_.plain();
  std::map<std::array<double, 6>, u32> vertices;
  const auto vertex = [&](const SurfaceSample& s) {
    const auto [known, is_new] =
        vertices.try_emplace({s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z});
    if (is_new) known->second = geometry_.add_vertex({s.position, s.normal});
    return known->second;
  };
  tessellate([&](const SurfaceSample& a, const SurfaceSample& b, const SurfaceSample& c) {
    const u32 first = vertex(a), second = vertex(b);
    geometry_.add_triangle(first, second, vertex(c), material);
  });
}

void Shapes::read_sphere(Text& text) {
  const glm::dvec3 centre = text.point("centre");
  const double radius = text.real("radius");
  add_curved([&](const EmitTriangle& emit) {
    tessellate_sphere(centre, radius, settings_.sphere_slices, settings_.sphere_stacks, emit);
  });
}

void Shapes::read_cone(Text& text) {
  const glm::dvec3 base = text.point("base");
  const double base_radius = text.real("radius of the base");
  const glm::dvec3 tip = text.point("apex");
  const double tip_radius = text.real("radius of the apex");
  if (settings_.cone_slices == 0) {
    ++cones_left_out_;
    return;
  }
  add_curved([&](const EmitTriangle& emit) {
    tessellate_cone(base, base_radius, tip, tip_radius, settings_.cone_slices, emit);
  });
}

void Shapes::read_polygon(Text& text, bool normals) {
  const size_t count = text.count("corners", normals ? 6 : 3);
  SceneBuilder::check_corners(count);
  corners_.resize(count);
  for (Corner& corner : corners_) {
    corner = {text.point("corner")};
    if (normals) corner.normal = text.point("normal");
  }
  geometry_.add_polygon(corners_, materials_.plain());
}

void Shapes::read_textured_triangle(Text& text, bool normals) {
  const std::string_view image = text.name("a texture");
  const u32 material = materials_.textured(image, text);
  Corner corners[3];
  for (Corner& corner : corners) {
    corner.position = text.point("corner");
    if (normals) corner.normal = text.point("normal");
    corner.texcoord.s = static_cast<float>(text.real("texture coordinate"));
    corner.texcoord.t = static_cast<float>(text.real("texture coordinate"));
  }
  add_triangle(corners, material);
}

void Shapes::read_animated_triangle(Text& text) {
  struct Key {
    double time;
    Corner corners[3];
  };
  const size_t count = text.count("keys", 19);
  if (count == 0) text.fail("an animated triangle without keys");
  Key before{}, after{};  // the keys around the time
  double latest = -kMaxFloat;
  for (size_t i = 0; i < count; ++i) {
    Key key{text.real("time of a key"), {}};
    for (Corner& corner : key.corners) corner = {text.point("corner"), text.point("normal")};
    if (i == 0) before = after = key;
    if (key.time < latest) text.fail("the times of the keys go back");
    latest = key.time;
    // `after` is the first key at or behind the time, or the last one of all.
    if (after.time < time_) before = std::exchange(after, key);
  }
  const double span = after.time - before.time;
  const double u = span > 0.0 ? std::clamp((time_ - before.time) / span, 0.0, 1.0) : 1.0;
  for (int i = 0; i < 3; ++i) {
    Corner& a = after.corners[i];
    const Corner& b = before.corners[i];
    a.position = b.position + u * (a.position - b.position);
    a.normal = b.normal + u * (a.normal - b.normal);
  }
  add_triangle(after.corners, materials_.plain());
}

}  // namespace raywalk::aff
