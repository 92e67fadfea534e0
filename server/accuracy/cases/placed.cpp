// Makes the closed meshes.
#include "server/accuracy/cases/placed.h"

#include <algorithm>
#include <cmath>

#include "server/accuracy/cases/hex.h"

namespace raywalk::accuracy {
namespace {

/// An edge function must stay this far from zero, in units of its largest terms: more than the 20 units of 2^-24 that
/// the triangle test may misplace a point by.
constexpr double kMargin = 0x1p-17;

bool sees(const Corners& t, Vec3 from) {
  const double p[3][3] = {
      {double{t.a.x} - from.x, double{t.a.y} - from.y, double{t.a.z} - from.z},
      {double{t.b.x} - from.x, double{t.b.y} - from.y, double{t.b.z} - from.z},
      {double{t.c.x} - from.x, double{t.c.y} - from.y, double{t.c.z} - from.z},
  };
  double reach = 0, edge = 0;
  for (int i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      reach = std::max(reach, std::abs(p[i][axis]));
      edge = std::max(edge, std::abs(p[i][axis] - p[(i + 1) % 3][axis]));
    }
  }
  const double volume = p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                        p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                        p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  return volume > kMargin * reach * reach * edge;
}

Mesh rounded_to_whole(Mesh mesh, float scale) {
  for (Corners& t : mesh)
    for (Vec3* p : {&t.a, &t.b, &t.c})
      *p = {std::nearbyint(p->x * scale), std::nearbyint(p->y * scale), std::nearbyint(p->z * scale)};
  return mesh;
}

/// Two fans of `count` triangles over one rim.
Mesh bipyramid(u32 count) {
  std::vector<Vec3> rim;
  for (u32 i = 0; i < count; ++i) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(count);
    rim.push_back({2.0f * std::cos(angle), 2.0f * std::sin(angle), 0.0f});
  }
  Mesh mesh;
  for (u32 i = 0; i < count; ++i) {
    const Vec3 p = rim[i], q = rim[(i + 1) % count];
    mesh.push_back(triangle({0, 0, 1.7f}, p, q));
    mesh.push_back(triangle({0, 0, -1.3f}, q, p));
  }
  return mesh;
}

/// Wound outward as seen from the origin.
Mesh wound_outward(Mesh mesh) {
  for (Corners& t : mesh)
    if (dot(t.a, cross(t.b, t.c)) < 0.0f) std::swap(t.b, t.c);
  return mesh;
}

Mesh stretched_sphere() {
  Mesh mesh = icosphere(3);
  for (Corners& t : mesh)
    for (Vec3* p : {&t.a, &t.b, &t.c}) p->y *= 30.0f;
  return mesh;
}

}  // namespace

std::vector<Vec3> seeing_all(const Mesh& mesh, const std::vector<Vec3>& candidates) {
  std::vector<Vec3> good;
  for (const Vec3 from : candidates)
    if (std::ranges::all_of(mesh, [&](const Corners& t) { return sees(t, from); })) good.push_back(from);
  return good;
}

Placed placed(std::string name, const Mesh& mesh, float scale, float offset, float room, Random random) {
  Placed result;
  result.name = std::move(name) + " x " + text_of(scale) + " + " + text_of(offset);
  const Vec3 centre = Vec3{1.0f, -1.0f, 0.5f} * offset;
  result.centre = centre;
  result.mesh = transformed(mesh, scale, centre);
  result.scene = scene_of(result.mesh);
  std::vector<Vec3> candidates = {centre};
  const Vec3 half{room, room, room};
  for (u32 i = 0; i < 24; ++i) candidates.push_back(random.in_box(-half, half) * scale + centre);
  result.inside = seeing_all(result.mesh, candidates);
  return result;
}

std::vector<Placed> placed_meshes(Random random) {
  struct Shape {
    std::string name;
    Mesh mesh;
    float room;
  };
  const Shape shapes[] = {
      {"sphere", icosphere(4, 2.0f), 0.5f},
      {"spiky sphere", spiky_mesh(random), 0.05f},
      {"box", wound_outward(subdivided_box(8)), 0.5f},
      {"quantised sphere", rounded_to_whole(icosphere(2), 16.0f), 2.0f},
      {"ellipsoid", stretched_sphere(), 0.3f},
      {"bipyramid", bipyramid(256), 0.3f},
  };
  std::vector<Placed> all;
  for (const Shape& shape : shapes) {
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
      for (const float offset : {0.0f, 1.0f, 1e3f, 1e6f}) {
        if (offset <= 1e6f * scale) all.push_back(placed(shape.name, shape.mesh, scale, offset, shape.room, random));
      }
    }
  }
  return all;
}

Mesh spiky_mesh(Random random) {
  constexpr u32 n = 16;
  std::vector<Vec3> points;  // rows from pole to pole
  for (u32 row = 0; row <= n; ++row) {
    for (u32 column = 0; column < n; ++column) {
      const float down = std::numbers::pi_v<float> * static_cast<float>(row) / n;
      const float round = 2.0f * std::numbers::pi_v<float> * static_cast<float>(column) / n;
      const Vec3 d{std::sin(down) * std::cos(round), std::cos(down), std::sin(down) * std::sin(round)};
      const bool pole = row == 0 || row == n;
      points.push_back(pole ? Vec3{0.0f, row == 0 ? 3.0f : -3.0f, 0.0f} : d * random.uniform(1.0f, 6.0f));
    }
  }
  const auto point = [&](u32 row, u32 column) { return points[row * n + column % n]; };
  Mesh mesh;
  for (u32 row = 0; row < n; ++row) {
    for (u32 column = 0; column < n; ++column) {
      if (row + 1 < n) mesh.push_back(triangle(point(row, column), point(row + 1, column + 1), point(row + 1, column)));
      if (row > 0) mesh.push_back(triangle(point(row, column), point(row, column + 1), point(row + 1, column + 1)));
    }
  }
  return wound_outward(std::move(mesh));
}

Ray ray_to_edge(Vec3 from, const Corners& triangle, u32 place, float along) {
  const Vec3 ends[4] = {triangle.a, triangle.b, triangle.c, triangle.a};
  return ray_towards(from, ends[place % 3] * (1.0f - along) + ends[place % 3 + 1] * along);
}

Ray ray_to_vertex(Vec3 from, const Corners& triangle, u32 place) {
  const Vec3 vertices[3] = {triangle.a, triangle.b, triangle.c};
  return ray_towards(from, vertices[place % 3]);
}

}  // namespace raywalk::accuracy
