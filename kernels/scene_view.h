// The scene as kernels see it: one blob of triangles, materials, textures and lights. Colours are linear RGB.
#pragma once
#include "kernels/blob.h"
#include "kernels/vec.h"

namespace raywalk {

/// The three vertices of one triangle with its id, 48 bytes, so that a structure may keep copies in its own order.
/// A triangle with a NaN or infinite vertex stays in place and is never hit: ids do not shift. One without an area has
/// NaN vertices here.
struct alignas(16) Corners {
  Vec3 a;
  u32 id;
  Vec3 b;
  u32 pad0;
  Vec3 c;
  u32 pad1;
};

/// Vertex indices (into normals and texture coordinates, when there are any) and the material of one triangle.
struct TriangleIndices {
  u32 a, b, c;
  u32 material;
};

/// Texture coordinates: (0, 0) is the upper left corner of the image, (1, 1) its lower right one; they repeat.
struct TexCoord {
  float s, t;
};

constexpr u32 kNoTexture = 0xffffffffu;

/// Phong with Whitted's mirror and glass terms; black unless said. Colours are in [0, 1] except emission (>= 0);
/// shininess is an exponent, ior > 0.
struct Material {
  Vec3 ambient{};
  Vec3 diffuse{};
  Vec3 specular{};
  Vec3 reflection{};    // weight of the mirrored ray
  Vec3 transmission{};  // weight of the refracted ray; colours shadows too
  Vec3 emission{};      // added whatever the lights do
  float shininess = 1.0f;
  float ior = 1.0f;
  u32 texture = kNoTexture;  // number of an image; its colour multiplies ambient and diffuse
};

/// One image among the texels. Behind it in the table come its smaller versions, each half as wide and high.
struct TextureImage {
  u32 width, height;
  u32 levels;  // this one and the smaller ones behind it
  u32 pad;
  u64 first_texel;  // of its upper left corner; rows run top down
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
  Slice<TexCoord> texcoords;  // one a vertex, or none at all
  Slice<TextureImage> textures;
  Slice<u32> texels;      // sRGB, eight bits each: red | green << 8 | blue << 16
  Slice<float> decoding;  // the 256 linear values of an eight-bit sRGB component; empty without textures
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
  RW_FN const TexCoord* texcoords() const { return data_of(blob, header().texcoords); }
  RW_FN const TextureImage* textures() const { return data_of(blob, header().textures); }
  RW_FN const u32* texels() const { return data_of(blob, header().texels); }
  RW_FN const float* decoding() const { return data_of(blob, header().decoding); }
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
