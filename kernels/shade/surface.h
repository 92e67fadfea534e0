// The point that a ray hit: position with its rounding error, normals, material.
#pragma once
#include "kernels/features.h"
#include "kernels/ray.h"
#include "kernels/scene_view.h"
#include "kernels/shade/texture.h"

namespace raywalk {

struct Surface {
  Vec3 position;
  Vec3 error;             // bound of the rounding error of position, per component
  float slack;            // how far beside its plane the triangle test may still see the triangle
  Vec3 geometric_normal;  // unit, by the winding
  Vec3 normal;            // unit, interpolated, on the side that the ray came from
  bool front;             // the ray came from the side that the geometric normal points to
  u32 material;
  Vec3 tint;  // the texture's colour, white without one; only with kFeatureTextures
};

/// The surface where a ray of direction `d` meets the triangle a b c at barycentrics u, v; no memory is read and no
/// branch is taken. `interpolated` is the sum of the weighted vertex normals, or zero when there are none.
RW_FN Surface surface_of(Vec3 a, Vec3 b, Vec3 c, float u, float v, Vec3 interpolated, Vec3 d, u32 material) {
  const Vec3 ab = b - a, ac = c - a;
  Surface s;
  s.position = a + (u * ab + v * ac);
  // The last addition rounds by half an ulp of the position; all that comes before by some units of the edges' length.
  s.error = magnitude(s.position) * 1.2e-7f;
  // The triangle test rounds vertices relative to the ray's origin, here at most an edge away, by about 10 units of
  // 2^-24; with the position's share there are 24.
  s.slack = 1.4305115e-6f * larger(largest(magnitude(c - b)), larger(largest(magnitude(ab)), largest(magnitude(ac))));
  // Scaled first, so that the product of two edges stays a float at any size of scene.
  const float scale = scale_of(larger(largest(magnitude(ab)), largest(magnitude(ac))));
  s.geometric_normal = normalized(cross(ab * scale, ac * scale));
  s.front = dot(d, s.geometric_normal) <= 0.0f;
  const float side = dot(interpolated, s.geometric_normal) < 0.0f ? -1.0f : 1.0f;
  const Vec3 n = interpolated * divide(side, length(interpolated));
  // False without vertex normals, which makes n NaN, and for ones that are not finite.
  const bool usable = dot(n, s.geometric_normal) >= 0.0f;
  const Vec3 shading{usable ? n.x : s.geometric_normal.x, usable ? n.y : s.geometric_normal.y,
                     usable ? n.z : s.geometric_normal.z};
  s.normal = shading * (s.front ? 1.0f : -1.0f);
  s.material = material;
  s.tint = {1, 1, 1};
  return s;
}

/// Sum of the weighted vertex normals at a hit; zero when the scene has none.
RW_FN Vec3 interpolated_normal(SceneView scene, const TriangleIndices& indices, float u, float v) {
  if (scene.header().normals.count == 0) return {0, 0, 0};
  const Vec3* normals = scene.normals();
  return (1.0f - u - v) * normals[indices.a] + u * normals[indices.b] + v * normals[indices.c];
}

/// `hit` is a hit of a ray with direction `d`; `width` is the diameter of its pixel's cone there, 0 for the finest
/// texels. Vertex normals and textures count where the features have them.
template <u32 kFeatures>
RW_FN Surface surface_at(SceneView scene, const Hit& hit, Vec3 d, float width) {
  const Corners& t = scene.corners()[hit.id];
  const TriangleIndices& indices = scene.triangles()[hit.id];
  Vec3 interpolated{0, 0, 0};
  if constexpr ((kFeatures & kFeatureNormals) != 0) interpolated = interpolated_normal(scene, indices, hit.u, hit.v);
  Surface s = surface_of(t.a, t.b, t.c, hit.u, hit.v, interpolated, d, indices.material);
  if constexpr ((kFeatures & kFeatureTextures) != 0) s.tint = tint_at(scene, t, indices, hit.u, hit.v, d, width);
  return s;
}

}  // namespace raywalk
