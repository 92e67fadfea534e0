// Spheres, cylinders, cones and cubes, tessellated, with the texture coordinates that the format gives them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "server/scene/formats/inventor/interpreter.h"

namespace raywalk {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr u32 kSlices = 40;  // of cylinders and cones

/// Once around the y axis from the back over the left; NaN on the axis, where every value would do.
double around(dvec3 p) {
  if (p.x == 0.0 && p.z == 0.0) return std::nan("");
  const double turns = std::atan2(-p.x, -p.z) / (2.0 * std::numbers::pi);
  return turns < 0.0 ? turns + 1.0 : turns;
}

/// Lets s run on where a triangle crosses the seam, and gives corners on the axis the middle of the other two.
void mend_seam(std::array<dvec2, 3>& st) {
  const auto known = std::find_if(st.begin(), st.end(), [](dvec2 c) { return !std::isnan(c.x); });
  if (known == st.end()) return;
  double sum = 0.0;
  int count = 0;
  for (dvec2& c : st) {
    if (std::isnan(c.x)) continue;
    if (c.x - known->x > 0.6) c.x -= 1.0;
    if (c.x - known->x < -0.6) c.x += 1.0;
    sum += c.x;
    ++count;
  }
  for (dvec2& c : st) {
    if (std::isnan(c.x)) c.x = sum / count;
  }
}

bool has_part(const IvFields& f, std::string_view part) {
  const IvField* parts = f.find("parts");
  if (parts == nullptr) return true;
  return std::any_of(parts->words.begin(), parts->words.end(),
                     [&](std::string_view word) { return word == part || word == "ALL"; });
}

}  // namespace

u32 IvInterpreter::part_material(u32 part) {
  const IvBinding binding = state_.material_binding;
  const bool by_part = binding == IvBinding::kPerPart || binding == IvBinding::kPerPartIndexed;
  return material_index(by_part ? part : 0);
}

EmitTriangle IvInterpreter::emit_solid(u32 material, TexcoordOf texcoord_of) {
  const bool textured = state_.texture != kNoTexture;
  return [=, this](const SurfaceSample& a, const SurfaceSample& b, const SurfaceSample& c) {
    std::array<dvec2, 3> st{};
    if (textured) {
      st = {texcoord_of(a), texcoord_of(b), texcoord_of(c)};
      mend_seam(st);
    }
    const MeshCorner corners[] = {corner(a.position, a.normal, st[0]), corner(b.position, b.normal, st[1]),
                                  corner(c.position, c.normal, st[2])};
    builder_.add_polygon(corners, material);
  };
}

void IvInterpreter::sphere(const IvFields& f) {
  if (!state_.visible) return;
  const double radius = f.number("radius", 1.0);
  const EmitTriangle emit = emit_solid(part_material(0), [](const SurfaceSample& s) {
    return dvec2(around(s.normal), 1.0 - std::acos(std::clamp(s.normal.y, -1.0, 1.0)) / std::numbers::pi);
  });
  const auto upright = [](SurfaceSample s) {  // the poles on y
    return SurfaceSample{{s.position.x, s.position.z, -s.position.y}, {s.normal.x, s.normal.z, -s.normal.y}};
  };
  tessellate_sphere(dvec3(0.0), radius, files_.settings().sphere_slices, files_.settings().sphere_stacks,
                    [&](const SurfaceSample& a, const SurfaceSample& b, const SurfaceSample& c) {
                      emit(upright(a), upright(b), upright(c));
                    });
}

void IvInterpreter::cylinder(const IvFields& f) {
  if (!state_.visible) return;
  const double radius = f.number("radius", 1.0), height = f.number("height", 2.0);
  const dvec3 top(0, height / 2, 0);
  const auto cap = [radius](double side) {
    return [=](const SurfaceSample& s) {
      return dvec2(0.5 + s.position.x / (2 * radius), 0.5 - side * s.position.z / (2 * radius));
    };
  };
  if (has_part(f, "SIDES")) {
    tessellate_cone(-top, radius, top, radius, kSlices, emit_solid(part_material(0), [height](const SurfaceSample& s) {
      return dvec2(around(s.position), s.position.y / height + 0.5);
    }));
  }
  if (has_part(f, "TOP")) {
    tessellate_ring(top, {0, 1, 0}, 0.0, radius, kSlices, emit_solid(part_material(1), cap(1.0)));
  }
  if (has_part(f, "BOTTOM")) {
    tessellate_ring(-top, {0, -1, 0}, 0.0, radius, kSlices, emit_solid(part_material(2), cap(-1.0)));
  }
}

void IvInterpreter::cone(const IvFields& f) {
  if (!state_.visible) return;
  const double radius = f.number("bottomRadius", 1.0), height = f.number("height", 2.0);
  const dvec3 tip(0, height / 2, 0);
  if (has_part(f, "SIDES")) {
    tessellate_cone(-tip, radius, tip, 0.0, kSlices, emit_solid(part_material(0), [height](const SurfaceSample& s) {
      return dvec2(around(s.position), s.position.y / height + 0.5);
    }));
  }
  if (has_part(f, "BOTTOM")) {
    const auto cap = [radius](const SurfaceSample& s) {
      return dvec2(0.5 + s.position.x / (2 * radius), 0.5 + s.position.z / (2 * radius));
    };
    tessellate_ring(-tip, {0, -1, 0}, 0.0, radius, kSlices, emit_solid(part_material(1), cap));
  }
}

void IvInterpreter::cube(const IvFields& f) {
  if (!state_.visible) return;
  const dvec3 half = 0.5 * dvec3(f.number("width", 2.0), f.number("height", 2.0), f.number("depth", 2.0));
  struct Side {
    dvec3 outward, right, up;
  };
  static const Side kSides[] = {
      {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
      {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},  {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
  };
  for (u32 part = 0; part < std::size(kSides); ++part) {
    const Side& side = kSides[part];
    std::array<MeshCorner, 4> corners;
    for (u32 i = 0; i < 4; ++i) {
      const dvec2 st(i == 1 || i == 2, i >= 2);
      const dvec3 p = side.outward + (2 * st.x - 1) * side.right + (2 * st.y - 1) * side.up;
      corners[i] = corner(half * p, side.outward, st);
    }
    builder_.add_polygon(corners, part_material(part));
  }
}

}  // namespace raywalk
