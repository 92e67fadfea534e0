// Scenes put together by hand: meshes with materials, textures, normals and lights.
#pragma once
#include <algorithm>
#include <vector>

#include "kernels/features.h"
#include "tests/support/meshes.h"
#include "tests/support/textures.h"

namespace raywalk::test {

inline Vec3 grey(float value) {
  return {value, value, value};
}

/// The four corners of a parallelogram in order; corner `a` gets texture coordinate (0, 0), b (1, 0), c (1, 1).
struct Quad {
  Vec3 a, b, c, d;
};

struct ShadedScene {
  struct Image {
    u32 width, height;
    std::vector<u32> texels;
    u32 levels = 1;  // with the smaller ones, which are the images behind it
  };
  Mesh mesh;
  std::vector<u32> material_of;     // one a triangle
  std::vector<Vec3> normals;        // three a triangle, or none
  std::vector<TexCoord> texcoords;  // three a triangle, or none
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<Light> lights;
  Vec3 background{}, ambient{};

  void add(const Mesh& more, u32 material) {
    append(mesh, more);
    material_of.resize(mesh.size(), material);
  }
  void add(const Quad& q, u32 material) {
    add({triangle(q.a, q.b, q.c), triangle(q.a, q.c, q.d)}, material);
    texcoords.resize(3 * mesh.size() - 6);
    texcoords.insert(texcoords.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}});
  }
};

inline u32 features_of(const ShadedScene& scene) {
  u32 features = scene.normals.empty() ? 0u : static_cast<u32>(kFeatureNormals);
  for (const Material& m : scene.materials) {
    if (largest(m.specular) > 0) features |= kFeatureSpecular;
    if (largest(m.reflection) > 0) features |= kFeatureReflection;
    if (largest(m.transmission) > 0) features |= kFeatureRefraction;
    if (m.texture != kNoTexture) features |= kFeatureTextures;
  }
  if (scene.lights.size() > 1) features |= kFeatureManyLights;
  return features;
}

/// The blob; every triangle has vertices of its own.
inline Blob pack_of(const ShadedScene& scene) {
  BlobPlan plan(sizeof(SceneHeader));
  SceneHeader header{};
  header.features = features_of(scene);
  header.background = scene.background;
  header.ambient = scene.ambient;
  header.corners = plan.add<Corners>(scene.mesh.size());
  header.triangles = plan.add<TriangleIndices>(scene.mesh.size());
  header.normals = plan.add<Vec3>(scene.normals.size());
  header.materials = plan.add<Material>(scene.materials.size());
  header.lights = plan.add<Light>(scene.lights.size());
  header.texcoords = plan.add<TexCoord>(scene.texcoords.size());
  header.textures = plan.add<TextureImage>(scene.images.size());
  u64 texels = 0;
  for (const ShadedScene::Image& image : scene.images) texels += image.texels.size();
  header.texels = plan.add<u32>(texels);
  header.decoding = plan.add<float>(scene.images.empty() ? 0 : 256);
  Blob blob = plan.allocate();
  std::memset(blob.data(), 0, blob.size_bytes());
  for (u32 i = 0; i < scene.mesh.size(); ++i) {
    Corners& corners = slice_of(blob, header.corners)[i];
    corners = scene.mesh[i];
    corners.id = i;
    header.bounds.add(bounds_of(corners));
    slice_of(blob, header.triangles)[i] = {3 * i, 3 * i + 1, 3 * i + 2, scene.material_of[i]};
  }
  std::ranges::copy(scene.normals, slice_of(blob, header.normals).begin());
  std::ranges::copy(scene.materials, slice_of(blob, header.materials).begin());
  std::ranges::copy(scene.lights, slice_of(blob, header.lights).begin());
  std::ranges::copy(scene.texcoords, slice_of(blob, header.texcoords).begin());
  u64 first = 0;
  for (size_t i = 0; i < scene.images.size(); ++i) {
    const ShadedScene::Image& image = scene.images[i];
    slice_of(blob, header.textures)[i] = {image.width, image.height, image.levels, 0, first};
    std::ranges::copy(image.texels, slice_of(blob, header.texels).begin() + static_cast<std::ptrdiff_t>(first));
    first += image.texels.size();
  }
  if (!scene.images.empty()) std::ranges::copy(srgb_decoding(), slice_of(blob, header.decoding).begin());
  std::memcpy(blob.data(), &header, sizeof header);
  return blob;
}

}  // namespace raywalk::test
