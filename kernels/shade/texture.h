// Colours of textures: bilinear between the four nearest texels, in linear light, the image repeated without end.
#pragma once
#include "kernels/ray.h"
#include "kernels/scene_view.h"
#include "kernels/shade/power.h"

namespace raywalk {

/// Two neighbours along one axis of an image and the weight of the second one.
struct TexelPair {
  u32 first, second;
  float weight;
};

/// The texels on either side of `coordinate` among `count` that repeat, of which texel i has its centre at
/// (i + 0.5) / count. Any coordinate gives two indices below `count`; one that is not finite counts as 0.
RW_FN TexelPair texels_around(float coordinate, u32 count) {
  // From 2^23 on every float is whole; the comparison is false for NaN.
  const float c = magnitude(coordinate) < 8388608.0f ? coordinate : 0.0f;
  const float signed_part = c - static_cast<float>(static_cast<i32>(c));
  const float part = signed_part < 0.0f ? signed_part + 1.0f : signed_part;
  // Half a texel further, so that truncation finds the texel whose centre is the next one, in [0, count].
  const float place = fma(part, static_cast<float>(count), 0.5f);
  const u32 next = smaller(static_cast<u32>(place), count);
  return {next == 0 ? count - 1 : next - 1, next == count ? 0 : next, place - static_cast<float>(next)};
}

/// The linear colour of an sRGB texel.
RW_FN Vec3 decoded(SceneView scene, u32 texel) {
  const float* table = scene.decoding();
  return {table[texel & 255u], table[(texel >> 8) & 255u], table[(texel >> 16) & 255u]};
}

/// The linear colour of an image of the scene; texels are decoded before they are mixed.
RW_FN Vec3 color_of(SceneView scene, const TextureImage& image, TexCoord at) {
  const TexelPair x = texels_around(at.s, image.width), y = texels_around(at.t, image.height);
  const u32* upper = scene.texels() + image.first_texel + u64{y.first} * image.width;
  const u32* lower = scene.texels() + image.first_texel + u64{y.second} * image.width;
  const auto mixed = [](Vec3 a, Vec3 b, float weight) { return fma(weight, b - a, a); };
  return mixed(mixed(decoded(scene, upper[x.first]), decoded(scene, upper[x.second]), x.weight),
               mixed(decoded(scene, lower[x.first]), decoded(scene, lower[x.second]), x.weight), y.weight);
}

/// Which of an image's levels has texels about as large as a pixel. `texels` is how many of its finest ones the pixel
/// sees.
RW_FN u32 level_of(const TextureImage& image, float texels) {
  if (!(texels > 1.0f)) return 0;  // NaN too
  return smaller(static_cast<u32>(fma(0.5f, log2_of(smaller(texels, kMaxFloat)), 0.5f)), image.levels - 1);
}

/// What multiplies a surface's ambient and diffuse colours: white where the material has no texture, or the scene no
/// texture coordinates. A ray of unit direction `d` met the triangle at u, v; `width` is the diameter of its pixel's
/// cone there (Akenine-Moeller et al., "Texture Level of Detail Strategies for Real-Time Ray Tracing", 2019; here by
/// the area that the cone cuts out, with the nearest level).
RW_FN Vec3 tint_at(SceneView scene, const Corners& t, const TriangleIndices& indices, float u, float v, Vec3 d,
                   float width) {
  const u32 texture = scene.materials()[indices.material].texture;
  if (texture == kNoTexture || scene.header().texcoords.count == 0) return {1, 1, 1};
  const TexCoord a = scene.texcoords()[indices.a], b = scene.texcoords()[indices.b], c = scene.texcoords()[indices.c];
  const float w = 1.0f - u - v;
  const TexCoord at{w * a.s + u * b.s + v * c.s, w * a.t + u * b.t + v * c.t};
  const TextureImage& image = scene.textures()[texture];
  const float image_area = magnitude((b.s - a.s) * (c.t - a.t) - (b.t - a.t) * (c.s - a.s));
  const float seen_area = magnitude(dot(d, cross(t.b - t.a, t.c - t.a)));
  const float size = static_cast<float>(image.width) * static_cast<float>(image.height);
  const u32 level = level_of(image, divide(image_area * size * (width * width), seen_area));
  return color_of(scene, scene.textures()[texture + level], at);
}

}  // namespace raywalk
