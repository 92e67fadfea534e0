// Deterministic meshes, scenes and rays for whatever checks the kernels.
#pragma once
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>
#include <vector>

#include "kernels/blob_writer.h"
#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk::accuracy {

using Mesh = std::vector<Corners>;

/// A minimal valid scene of `mesh`: one material, one light, no normals. Ids are set to the position in `mesh`.
inline Blob make_scene(Mesh mesh) {
  BlobPlan plan(sizeof(SceneHeader));
  SceneHeader header{};
  header.corners = plan.add<Corners>(mesh.size());
  header.triangles = plan.add<TriangleIndices>(mesh.size());
  header.normals = plan.add<Vec3>(0);
  header.materials = plan.add<Material>(1);
  header.lights = plan.add<Light>(1);
  Blob blob = plan.allocate();
  std::memset(blob.data(), 0, blob.size_bytes());
  for (u32 i = 0; i < mesh.size(); ++i) {
    mesh[i].id = i;
    mesh[i].pad0 = mesh[i].pad1 = 0;
    if (is_finite(mesh[i])) header.bounds.add(bounds_of(mesh[i]));
    slice_of(blob, header.corners)[i] = mesh[i];
    slice_of(blob, header.triangles)[i] = {3 * i, 3 * i + 1, 3 * i + 2, 0};
  }
  slice_of(blob, header.materials)[0] = {.ambient = {0.1f, 0.1f, 0.1f}, .diffuse = {0.8f, 0.8f, 0.8f}};
  slice_of(blob, header.lights)[0] = {.position = {10.0f, 10.0f, 10.0f}, .intensity = {1.0f, 1.0f, 1.0f}};
  std::memcpy(blob.data(), &header, sizeof header);
  return blob;
}

inline SceneView view_of(const Blob& scene) {
  return {scene.data()};
}

inline Corners triangle(Vec3 a, Vec3 b, Vec3 c) {
  return {a, 0, b, 0, c, 0};
}

/// Seeded numbers that do not depend on the standard library's distributions.
class Random {
 public:
  explicit Random(u32 seed) : engine_(seed) {}
  u32 below(u32 n) { return static_cast<u32>((static_cast<u64>(engine_()) * n) >> 32); }
  /// Uniform in [lo, hi).
  float uniform(float lo = 0.0f, float hi = 1.0f) {
    return lo + (hi - lo) * (static_cast<float>(engine_() >> 8) * 0x1p-24f);
  }
  Vec3 in_box(Vec3 lo, Vec3 hi) { return {uniform(lo.x, hi.x), uniform(lo.y, hi.y), uniform(lo.z, hi.z)}; }
  /// Uniform on the unit sphere, up to rounding.
  Vec3 direction() {
    for (;;) {
      const Vec3 p = in_box({-1, -1, -1}, {1, 1, 1});
      const float squared = dot(p, p);
      if (squared > 1e-4f && squared <= 1.0f) return normalized(p);
    }
  }

 private:
  std::mt19937 engine_;
};

// ---- Meshes ----

/// `count` triangles with one vertex anywhere in the cube [-1, 1]^3 and the others within `size` of it.
inline Mesh random_soup(u32 seed, u32 count, float size = 0.2f) {
  Random random(seed);
  Mesh mesh;
  mesh.reserve(count);
  const Vec3 reach{size, size, size};
  for (u32 i = 0; i < count; ++i) {
    const Vec3 p = random.in_box({-1, -1, -1}, {1, 1, 1});
    const Vec3 q = p + random.in_box(-reach, reach), r = p + random.in_box(-reach, reach);
    mesh.push_back(triangle(p, q, r));
  }
  return mesh;
}

/// Needles: two vertices nearly coincide, the third is far away.
inline Mesh slivers(u32 seed, u32 count) {
  Random random(seed);
  Mesh mesh;
  for (u32 i = 0; i < count; ++i) {
    const Vec3 p = random.in_box({-1, -1, -1}, {1, 1, 1});
    mesh.push_back(triangle(p, p + random.direction() * 1e-5f, random.in_box({-1, -1, -1}, {1, 1, 1})));
  }
  return mesh;
}

/// An icosahedron of 20 * 4^level triangles whose neighbours share their vertices bit for bit, wound outward.
inline Mesh icosphere(u32 level, float radius = 1.0f, Vec3 centre = {0, 0, 0}) {
  const float g = std::numbers::phi_v<float>;
  const Vec3 v[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  const u32 f[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  Mesh mesh;
  for (const auto& face : f) {
    mesh.push_back(triangle(normalized(v[face[0]]), normalized(v[face[1]]), normalized(v[face[2]])));
  }
  for (u32 i = 0; i < level; ++i) {
    Mesh finer;
    for (const Corners& t : mesh) {
      const Vec3 ab = normalized(t.a + t.b), bc = normalized(t.b + t.c), ca = normalized(t.c + t.a);
      finer.push_back(triangle(t.a, ab, ca));
      finer.push_back(triangle(ab, t.b, bc));
      finer.push_back(triangle(ca, bc, t.c));
      finer.push_back(triangle(ab, bc, ca));
    }
    mesh = std::move(finer);
  }
  for (Corners& t : mesh) {
    t.a = fma(radius, t.a, centre);
    t.b = fma(radius, t.b, centre);
    t.c = fma(radius, t.c, centre);
  }
  return mesh;
}

/// A flat n x n grid of quads (2 n^2 triangles) perpendicular to `axis` at `height`, from `lo` to `hi` on both other
/// axes.
inline Mesh quad_grid(u32 n, u32 axis = 2, float height = 0.0f, float lo = -1.0f, float hi = 1.0f) {
  const auto point = [&](u32 i, u32 j) {
    const float p = lo + (hi - lo) * (static_cast<float>(i) / static_cast<float>(n));
    const float q = lo + (hi - lo) * (static_cast<float>(j) / static_cast<float>(n));
    return axis == 0 ? Vec3{height, p, q} : axis == 1 ? Vec3{q, height, p} : Vec3{p, q, height};
  };
  Mesh mesh;
  for (u32 j = 0; j < n; ++j) {
    for (u32 i = 0; i < n; ++i) {
      mesh.push_back(triangle(point(i, j), point(i + 1, j), point(i + 1, j + 1)));
      mesh.push_back(triangle(point(i, j), point(i + 1, j + 1), point(i, j + 1)));
    }
  }
  return mesh;
}

inline void append(Mesh& to, const Mesh& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// The cube [lo, hi]^3 with n x n quads a face.
inline Mesh subdivided_box(u32 n, float lo = -1.0f, float hi = 1.0f) {
  Mesh mesh;
  for (u32 axis = 0; axis < 3; ++axis) {
    append(mesh, quad_grid(n, axis, lo, lo, hi));
    append(mesh, quad_grid(n, axis, hi, lo, hi));
  }
  return mesh;
}

/// Random triangles with integer vertices in [0, size]^3; some are degenerate, many share vertices, edges and planes.
inline Mesh integer_lattice(u32 seed, u32 count, u32 size) {
  Random random(seed);
  const auto whole = [&] { return static_cast<float>(random.below(size + 1)); };
  Mesh mesh;
  for (u32 i = 0; i < count; ++i) {
    Vec3 p[3];
    for (Vec3& q : p) q = {whole(), whole(), whole()};
    mesh.push_back(triangle(p[0], p[1], p[2]));
  }
  return mesh;
}

/// Every vertex p becomes p * scale + offset.
inline Mesh transformed(Mesh mesh, float scale, Vec3 offset) {
  for (Corners& t : mesh) {
    t.a = t.a * scale + offset;
    t.b = t.b * scale + offset;
    t.c = t.c * scale + offset;
  }
  return mesh;
}

inline Box bounds_of(const Mesh& mesh) {
  Box box;
  for (const Corners& t : mesh) {
    if (is_finite(t)) box.add(raywalk::bounds_of(t));
  }
  return box;
}

// ---- Rays ----

constexpr float kFarAway = 1e30f;

inline Ray ray_towards(Vec3 origin, Vec3 target) {
  return {origin, 0.0f, target - origin, kFarAway};
}

/// Origins inside a box `reach` times as large as the bounds, random directions of random length.
inline std::vector<Ray> random_rays(u32 seed, u32 count, const Box& bounds, float reach = 2.0f) {
  Random random(seed);
  const Vec3 centre = bounds.centre(), half = bounds.extent() * (0.5f * reach);
  std::vector<Ray> rays;
  for (u32 i = 0; i < count; ++i) {
    const Vec3 origin = random.in_box(centre - half, centre + half);
    rays.push_back({origin, 0.0f, random.direction() * random.uniform(0.5f, 2.0f), kFarAway});
  }
  return rays;
}

/// Rays from around the bounds at points on edges of random triangles.
inline std::vector<Ray> edge_rays(u32 seed, u32 count, const Mesh& mesh, float reach = 3.0f) {
  Random random(seed);
  const Box bounds = bounds_of(mesh);
  const float far = length(bounds.extent()) * 0.5f * reach;
  std::vector<Ray> rays;
  for (u32 i = 0; i < count; ++i) {
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const Vec3 ends[4] = {t.a, t.b, t.c, t.a};
    const u32 edge = random.below(3);
    const float s = random.below(2) ? 0.5f : random.uniform();
    rays.push_back(
        ray_towards(fma(far, random.direction(), bounds.centre()), ends[edge] * (1.0f - s) + ends[edge + 1] * s));
  }
  return rays;
}

/// Rays from around the bounds at vertices of random triangles.
inline std::vector<Ray> vertex_rays(u32 seed, u32 count, const Mesh& mesh, float reach = 3.0f) {
  Random random(seed);
  const Box bounds = bounds_of(mesh);
  const float far = length(bounds.extent()) * 0.5f * reach;
  std::vector<Ray> rays;
  for (u32 i = 0; i < count; ++i) {
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const Vec3 ends[3] = {t.a, t.b, t.c};
    rays.push_back(ray_towards(fma(far, random.direction(), bounds.centre()), ends[random.below(3)]));
  }
  return rays;
}

/// Axis-parallel rays through vertices and edge midpoints of random triangles, the other direction components +0 or -0.
inline std::vector<Ray> axis_rays(u32 seed, u32 count, const Mesh& mesh) {
  Random random(seed);
  const Box bounds = bounds_of(mesh);
  const float far = 2.0f * largest(bounds.extent());
  const auto zero = [&] { return random.below(2) ? 0.0f : -0.0f; };
  std::vector<Ray> rays;
  for (u32 i = 0; i < count; ++i) {
    const Corners& t = mesh[random.below(static_cast<u32>(mesh.size()))];
    const Vec3 p = random.below(2) ? t.a : 0.5f * t.b + 0.5f * t.c;
    const float sign = random.below(2) ? 1.0f : -1.0f;
    const u32 axis = random.below(3);
    Vec3 d{zero(), zero(), zero()}, o = p;
    (axis == 0 ? d.x : axis == 1 ? d.y : d.z) = sign;
    (axis == 0 ? o.x : axis == 1 ? o.y : o.z) -= sign * (random.below(2) ? far : 0.0f);
    rays.push_back({o, 0.0f, d, kFarAway});
  }
  return rays;
}

}  // namespace raywalk::accuracy
