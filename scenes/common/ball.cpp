// Tessellation of a closed surface: an icosahedron with divided edges, and some triangles cut in three to meet the
// count.
#include <array>
#include <cmath>

#include "scenes/common/surface.h"

namespace raywalk {
namespace {

constexpr u32 kCorners = 12, kEdges = 30, kFaces = 20;
constexpr u32 kFaceCorners[kFaces][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                         {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                         {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                         {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

Vec3 corner_direction(u32 i) {
  const float g = 1.618033988749895f;
  // Three rectangles of golden ratio: corner i lies in rectangle i / 4.
  const float one = i % 2 ? 1.0f : -1.0f, golden = i % 4 / 2 ? -g : g;
  switch (i / 4) {
    case 0:
      return normalized({one, golden, 0.0f});
    case 1:
      return normalized({0.0f, one, golden});
    default:
      return normalized({golden, 0.0f, one});
  }
}

/// Numbers the vertices of the divided icosahedron: corners, then points inside edges, then points inside faces.
class Net {
 public:
  explicit Net(u64 divisions) : m_(divisions) {
    u32 edges = 0;
    for (auto& row : edge_) row.fill(kEdges);
    for (const auto& face : kFaceCorners) {
      for (u32 k = 0; k < 3; ++k) {
        const u32 a = face[k], b = face[(k + 1) % 3];
        if (a < b) edge_[a][b] = edge_[b][a] = edges++;
      }
    }
  }
  u64 vertices() const { return 10 * m_ * m_ + 2; }

  /// The point of a face with weights m - i - j, i, j of its three corners.
  u64 index(u32 face, u64 i, u64 j) const {
    const auto [a, b, c] = kFaceCorners[face];
    if (i == 0 && j == 0) return a;
    if (i == m_) return b;
    if (j == m_) return c;
    if (j == 0) return on_edge(a, b, i);
    if (i == 0) return on_edge(a, c, j);
    if (i + j == m_) return on_edge(b, c, j);
    const u64 before = (j - 1) * (m_ - 1) - j * (j - 1) / 2;  // points of the rows 1 to j - 1
    return kCorners + kEdges * (m_ - 1) + face * ((m_ - 1) * (m_ - 2) / 2) + before + (i - 1);
  }
  Vec3 direction(u32 face, u64 i, u64 j) const {
    const auto [a, b, c] = kFaceCorners[face];
    return normalized(static_cast<float>(m_ - i - j) * corner_direction(a) +
                      static_cast<float>(i) * corner_direction(b) + static_cast<float>(j) * corner_direction(c));
  }
  /// Calls visit(direction) for all vertices in the order of their numbers.
  template <class Visit>
  void for_each_vertex(Visit visit) const {
    for (u32 i = 0; i < kCorners; ++i) visit(corner_direction(i));
    for (u32 edge = 0; edge < kEdges; ++edge) {
      const auto [a, b] = ends(edge);
      for (u64 i = 1; i < m_; ++i) {
        visit(
            normalized(static_cast<float>(m_ - i) * corner_direction(a) + static_cast<float>(i) * corner_direction(b)));
      }
    }
    for (u32 face = 0; face < kFaces; ++face) {
      for (u64 j = 1; j + 1 < m_; ++j) {
        for (u64 i = 1; i + j < m_; ++i) visit(direction(face, i, j));
      }
    }
  }

 private:
  u64 on_edge(u32 a, u32 b, u64 steps) const {
    return kCorners + edge_[a][b] * (m_ - 1) + (a < b ? steps : m_ - steps) - 1;
  }
  std::array<u32, 2> ends(u32 edge) const {
    for (u32 a = 0; a < kCorners; ++a) {
      for (u32 b = a + 1; b < kCorners; ++b) {
        if (edge_[a][b] == edge) return {a, b};
      }
    }
    return {0, 0};
  }

  u64 m_;
  std::array<std::array<u32, kCorners>, kCorners> edge_;
};

}  // namespace

void add_ball(TriangleSink& sink, const BallShape& shape, u32 material, u64 triangles) {
  u64 m = static_cast<u64>(std::sqrt(static_cast<double>(triangles) / kFaces));
  while (kFaces * m * m > triangles) --m;
  const Net net(m);
  const u64 plain = kFaces * m * m;
  const u64 cuts = (triangles - plain) / 2;
  const float spacing = 1.107f / static_cast<float>(m);

  const auto add_vertex = [&](Vec3 direction) {
    const SurfacePoint p = sink.counts_only() ? SurfacePoint{} : shape(direction, spacing);
    return sink.add_vertex(p.position, p.normal);
  };
  u32 last = 0;
  net.for_each_vertex([&](Vec3 direction) { last = add_vertex(direction); });
  const u64 first = last + 1 - net.vertices();

  u64 done = 0;
  const auto triangle = [&](u32 face, std::array<u64, 2> p, std::array<u64, 2> q, std::array<u64, 2> r) {
    const u32 a = static_cast<u32>(first + net.index(face, p[0], p[1]));
    const u32 b = static_cast<u32>(first + net.index(face, q[0], q[1]));
    const u32 c = static_cast<u32>(first + net.index(face, r[0], r[1]));
    const bool cut = (done + 1) * cuts / plain > done * cuts / plain;
    ++done;
    if (!cut) {
      sink.add_triangle({a, b, c, material});
      return;
    }
    const u32 middle = add_vertex(normalized(net.direction(face, p[0], p[1]) + net.direction(face, q[0], q[1]) +
                                             net.direction(face, r[0], r[1])));
    sink.add_triangle({a, b, middle, material});
    sink.add_triangle({b, c, middle, material});
    sink.add_triangle({c, a, middle, material});
  };
  for (u32 face = 0; face < kFaces; ++face) {
    for (u64 j = 0; j < m; ++j) {
      for (u64 i = 0; i + j < m; ++i) {
        triangle(face, {i, j}, {i + 1, j}, {i, j + 1});
        if (i + j + 1 < m) triangle(face, {i + 1, j}, {i + 1, j + 1}, {i, j + 1});
      }
    }
  }
}

}  // namespace raywalk
