// Scene -> kernel blob, bounds, features and identity.
#include "server/scene/scene.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "kernels/features.h"
#include "server/scene/degenerate.h"
#include "server/scene/mip_levels.h"
#include "server/system/sha256.h"

namespace raywalk {
namespace {

bool any(Vec3 colour) {
  return colour.x > 0.0f || colour.y > 0.0f || colour.z > 0.0f;
}

/// A triangle without an area becomes one without vertices: seen obliquely its corners round to something that has one.
Corners corners_of(const Scene& scene, const TriangleIndices& t, u32 id) {
  const Corners corners{scene.positions[t.a], id, scene.positions[t.b], 0, scene.positions[t.c], 0};
  if (!is_finite(corners) || !is_degenerate(corners)) return corners;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  return {{kNan, kNan, kNan}, id, {kNan, kNan, kNan}, 0, {kNan, kNan, kNan}, 0};
}

void check(const Scene& scene) {
  if (!scene.normals.empty() && scene.normals.size() != scene.positions.size()) {
    throw std::invalid_argument("scene " + scene.name + ": " + std::to_string(scene.normals.size()) + " normals for " +
                                std::to_string(scene.positions.size()) + " vertices");
  }
  if (!scene.texcoords.empty() && scene.texcoords.size() != scene.positions.size()) {
    throw std::invalid_argument("scene " + scene.name + ": " + std::to_string(scene.texcoords.size()) +
                                " texture coordinates for " + std::to_string(scene.positions.size()) + " vertices");
  }
  for (const Texture& t : scene.textures) {
    if (t.width == 0 || t.height == 0 || t.texels.size() != u64{t.width} * t.height) {
      throw std::invalid_argument("scene " + scene.name + ": texture " + t.name + " is not " + std::to_string(t.width) +
                                  " x " + std::to_string(t.height) + " texels");
    }
  }
  for (const Material& m : scene.materials) {
    if (m.texture != kNoTexture && m.texture >= scene.textures.size()) {
      throw std::invalid_argument("scene " + scene.name + ": a material has texture " + std::to_string(m.texture) +
                                  " of " + std::to_string(scene.textures.size()));
    }
  }
  if (scene.triangles.size() > 0xffffffffull)
    throw std::invalid_argument("scene " + scene.name + ": too many triangles");
  const u64 vertices = scene.positions.size();
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const TriangleIndices& t = scene.triangles[i];
    if (std::max({t.a, t.b, t.c}) >= vertices) {
      throw std::invalid_argument("scene " + scene.name + ": triangle " + std::to_string(i) +
                                  " names a vertex beyond " + std::to_string(vertices));
    }
    if (t.material >= scene.materials.size()) {
      throw std::invalid_argument("scene " + scene.name + ": triangle " + std::to_string(i) + " has material " +
                                  std::to_string(t.material) + " of " + std::to_string(scene.materials.size()));
    }
  }
}

template <class T>
void copy_into(Blob& blob, Slice<T> slice, const std::vector<T>& values) {
  if (!values.empty()) std::memcpy(blob.data() + slice.offset, values.data(), values.size() * sizeof(T));
}

/// Every image with its smaller versions behind it.
class TextureTable {
 public:
  explicit TextureTable(const std::vector<Texture>& textures) {
    for (const Texture& texture : textures) {
      first_image_.push_back(images_);
      const MipCounts smaller = mip_counts(texture.width, texture.height);
      images_ += 1 + smaller.levels;
      texels_ += texture.texels.size() + smaller.texels;
    }
  }
  u64 images() const { return images_; }
  u64 texels() const { return texels_; }
  /// Number of the image that holds texture `texture` itself.
  u32 first_image(u32 texture) const { return texture == kNoTexture ? kNoTexture : first_image_[texture]; }

 private:
  std::vector<u32> first_image_;
  u32 images_ = 0;
  u64 texels_ = 0;
};

void copy_textures(Blob& blob, const SceneHeader& header, const std::vector<Texture>& textures) {
  const std::span<TextureImage> images = slice_of(blob, header.textures);
  const std::span<u32> texels = slice_of(blob, header.texels);
  const std::span<float> decoding = slice_of(blob, header.decoding);
  size_t image = 0;
  u64 first = 0;
  const auto add = [&](const Texture& texture, u32 levels) {
    images[image++] = {texture.width, texture.height, levels, 0, first};
    std::copy(texture.texels.begin(), texture.texels.end(), texels.begin() + static_cast<std::ptrdiff_t>(first));
    first += texture.texels.size();
  };
  for (const Texture& texture : textures) {
    const std::vector<Texture> smaller = mip_levels(texture);
    u32 levels = static_cast<u32>(1 + smaller.size());
    add(texture, levels);
    for (const Texture& level : smaller) add(level, --levels);
  }
  for (u32 i = 0; i < decoding.size(); ++i) decoding[i] = linear_of_srgb(i);
}

template <class T>
void add_array(Sha256& hash, const std::vector<T>& values) {
  const u64 count = values.size();
  hash.add(&count, sizeof count);
  hash.add(values.data(), values.size() * sizeof(T));
}

}  // namespace

const char* fidelity_name(Fidelity fidelity) {
  switch (fidelity) {
    case Fidelity::kOriginal:
      return "original";
    case Fidelity::kDerived:
      return "derived";
    case Fidelity::kStandIn:
      return "stand-in";
    case Fidelity::kProcedural:
      break;
  }
  return "procedural";
}

Material default_material() {
  Material m{};
  m.ambient = m.diffuse = {0.7f, 0.7f, 0.7f};
  m.specular = {0.2f, 0.2f, 0.2f};
  m.shininess = 30.0f;
  m.ior = 1.0f;
  return m;
}

Box bounds_of(const Scene& scene) {
  Box bounds;
  for (const TriangleIndices& t : scene.triangles) {
    const Corners corners = corners_of(scene, t, 0);
    if (is_finite(corners)) bounds.add(bounds_of(corners));
  }
  return bounds;
}

u32 features_of(const Scene& scene) {
  u32 features = scene.normals.empty() ? 0u : static_cast<u32>(kFeatureNormals);
  for (const Material& m : scene.materials) {
    if (any(m.specular)) features |= kFeatureSpecular;
    if (any(m.reflection)) features |= kFeatureReflection;
    if (any(m.transmission)) features |= kFeatureRefraction;
    if (m.texture != kNoTexture) features |= kFeatureTextures;
  }
  if (scene.lights.size() > 1) features |= kFeatureManyLights;
  return features;
}

Blob pack(const Scene& scene) {
  check(scene);
  BlobPlan plan(sizeof(SceneHeader));
  SceneHeader header{};
  header.corners = plan.add<Corners>(scene.triangles.size());
  header.triangles = plan.add<TriangleIndices>(scene.triangles.size());
  header.normals = plan.add<Vec3>(scene.normals.size());
  header.materials = plan.add<Material>(scene.materials.size());
  header.lights = plan.add<Light>(scene.lights.size());
  header.texcoords = plan.add<TexCoord>(scene.texcoords.size());
  const TextureTable table(scene.textures);
  header.textures = plan.add<TextureImage>(table.images());
  header.texels = plan.add<u32>(table.texels());
  header.decoding = plan.add<float>(scene.textures.empty() ? 0 : 256);
  header.features = features_of(scene);
  header.background = scene.background;
  header.ambient = scene.ambient;

  Blob blob = plan.allocate();
  const std::span<Corners> corners = slice_of(blob, header.corners);
  for (size_t i = 0; i < corners.size(); ++i) {
    corners[i] = corners_of(scene, scene.triangles[i], static_cast<u32>(i));
    if (is_finite(corners[i])) header.bounds.add(bounds_of(corners[i]));
  }
  copy_into(blob, header.triangles, scene.triangles);
  copy_into(blob, header.normals, scene.normals);
  copy_into(blob, header.materials, scene.materials);
  for (Material& m : slice_of(blob, header.materials)) m.texture = table.first_image(m.texture);
  copy_into(blob, header.lights, scene.lights);
  copy_into(blob, header.texcoords, scene.texcoords);
  copy_textures(blob, header, scene.textures);
  std::memcpy(blob.data(), &header, sizeof header);
  return blob;
}

std::string geometry_sha256(const Scene& scene) {
  Sha256 hash;
  add_array(hash, scene.positions);
  add_array(hash, scene.normals);
  add_array(hash, scene.triangles);
  return hash.hex();
}

}  // namespace raywalk
