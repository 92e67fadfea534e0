// The scene as kernels see it: one blob of triangles, materials and lights. Colours are linear RGB.
#pragma once
#include "kernels/blob.h"
#include "kernels/vec.h"

namespace raywalk {

/// The three vertices of one triangle with its id, 48 bytes, so that a structure may keep copies in its own order.
/// A triangle with a NaN or infinite vertex stays in place and is never hit: ids do not shift.
struct alignas(16) Corners {
  Vec3 a;
  u32 id;
  Vec3 b;
  u32 pad0;
  Vec3 c;
  u32 pad1;
};

/// Vertex indices (into normals, when there are any) and the material of one triangle.
struct TriangleIndices {
  u32 a, b, c;
  u32 material;
};

/// Phong with Whitted's mirror and glass terms. All in [0, 1] except shininess (exponent) and ior (> 0).
struct Material {
  Vec3 ambient;
  Vec3 diffuse;
  Vec3 specular;
  Vec3 reflection;    // weight of the mirrored ray
  Vec3 transmission;  // weight of the refracted ray
  float shininess;
  float ior;
};

/// Point light without attenuation.
struct Light {
  Vec3 position;
  Vec3 intensity;
};

struct SceneHeader {
  Box bounds;  // of all finite triangles; empty when there is none
  u32 features;
  u32 pad;
  Vec3 background;
  Vec3 ambient;  // ambient light, multiplies Material::ambient
  Slice<Corners> corners;
  Slice<TriangleIndices> triangles;
  Slice<Vec3> normals;  // one a vertex, or none at all
  Slice<Material> materials;
  Slice<Light> lights;
};

/// Access by name; copy freely, it is one pointer.
struct SceneView {
  const u8* blob;
  RW_FN const SceneHeader& header() const { return header_of<SceneHeader>(blob); }
  RW_FN const Corners* corners() const { return data_of(blob, header().corners); }
  RW_FN const TriangleIndices* triangles() const { return data_of(blob, header().triangles); }
  RW_FN const Vec3* normals() const { return data_of(blob, header().normals); }
  RW_FN const Material* materials() const { return data_of(blob, header().materials); }
  RW_FN const Light* lights() const { return data_of(blob, header().lights); }
  RW_FN u32 triangle_count() const { return static_cast<u32>(header().corners.count); }
  RW_FN u32 light_count() const { return static_cast<u32>(header().lights.count); }
};

RW_FN bool is_finite(const Corners& t) {
  return is_finite(t.a) && is_finite(t.b) && is_finite(t.c);
}
RW_FN Box bounds_of(const Corners& t) {
  Box box;
  box.add(t.a);
  box.add(t.b);
  box.add(t.c);
  return box;
}

}  // namespace raywalk
