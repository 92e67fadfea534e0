// The mapping that formats/README.md describes.
#include "server/scene/formats/gltf/material.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "server/scene/mip_levels.h"
#include "server/scene/text.h"

namespace raywalk::gltf {
namespace {

Vec3 colour_of(const std::vector<double>& values, float otherwise) {
  const auto component = [&](size_t i) { return i < values.size() ? static_cast<float>(values[i]) : otherwise; };
  return {component(0), component(1), component(2)};
}

float unit(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

Vec3 unit(Vec3 colour) {
  return {unit(colour.x), unit(colour.y), unit(colour.z)};
}

Vec3 mixed(Vec3 a, Vec3 b, float share_of_b) {
  return (1.0f - share_of_b) * a + share_of_b * b;
}

/// The number `name` of an extension; `otherwise` if there is none.
double number_of(const tinygltf::ExtensionMap& extensions, const char* extension, const char* name, double otherwise) {
  const auto found = extensions.find(extension);
  if (found == extensions.end() || !found->second.IsObject()) return otherwise;
  const tinygltf::Value& value = found->second.Get(name);
  return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

/// Both numbers of the array `name`, if it is one.
void read_pair(const tinygltf::Value& object, const char* name, double& first, double& second) {
  const tinygltf::Value& pair = object.Get(name);
  if (!pair.IsArray() || pair.ArrayLen() != 2) return;
  if (pair.Get(0).IsNumber()) first = pair.Get(0).GetNumberAsDouble();
  if (pair.Get(1).IsNumber()) second = pair.Get(1).GetNumberAsDouble();
}

/// "%20" and the like become bytes.
std::string percent_decoded(const std::string& uri) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const int letter = (c | 0x20) - 'a';
    return letter >= 0 && letter < 6 ? letter + 10 : -1;
  };
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    text += escape ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return text;
}

constexpr float kMostShininess = 1000.0f;

/// Phong's exponent for a microfacet surface of this roughness.
float shininess_of(float roughness) {
  const float alpha = roughness * roughness;
  return std::clamp(2.0f / std::max(alpha * alpha, 1e-6f) - 2.0f, 1.0f, kMostShininess);
}

}  // namespace

TexCoord TexcoordTransform::operator()(TexCoord uv) const {
  const double s = scale_s * uv.s, t = scale_t * uv.t, cosine = std::cos(rotation_rad), sine = std::sin(rotation_rad);
  return {static_cast<float>(cosine * s + sine * t + offset_s), static_cast<float>(cosine * t - sine * s + offset_t)};
}

const UsedMaterial& Materials::use(int index, const std::string& part) {
  if (const auto known = used_.find(index); known != used_.end()) return known->second;
  if (index < 0) return used_[index] = {builder_.add_material(default_material())};
  const tinygltf::Material& source = document_.element(document_.model.materials, index, "material", part);
  return used_[index] = convert(source, "materials/" + std::to_string(index));
}

UsedMaterial Materials::convert(const tinygltf::Material& source, const std::string& part) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const auto warn = [&](const std::string& what) { builder_.warn(document_.at(part), what); };
  UsedMaterial used;
  Material m{};
  if (const tinygltf::TextureInfo& base = pbr.baseColorTexture; base.index >= 0) {
    m.texture = texture(base.index, part);
    used.texcoord_set = base.texCoord;
    const auto extension = base.extensions.find("KHR_texture_transform");
    if (extension != base.extensions.end() && extension->second.IsObject()) {
      TexcoordTransform& transform = used.transform;
      read_pair(extension->second, "offset", transform.offset_s, transform.offset_t);
      read_pair(extension->second, "scale", transform.scale_s, transform.scale_t);
      const tinygltf::Value& rotation = extension->second.Get("rotation");
      if (rotation.IsNumber()) transform.rotation_rad = rotation.GetNumberAsDouble();
      const tinygltf::Value& set = extension->second.Get("texCoord");
      if (set.IsInt()) used.texcoord_set = set.GetNumberAsInt();
    }
  }

  const Vec3 base = unit(colour_of(pbr.baseColorFactor, 1.0f));
  const float alpha = pbr.baseColorFactor.size() == 4 ? unit(pbr.baseColorFactor[3]) : 1.0f;
  float metallic = unit(pbr.metallicFactor), roughness = unit(pbr.roughnessFactor);
  if (const auto mean = mean_of(pbr.metallicRoughnessTexture.index, part)) {
    roughness *= mean->raw.y;
    metallic *= mean->raw.z;
  }
  m.emission =
      colour_of(source.emissiveFactor, 0.0f) *
      static_cast<float>(number_of(source.extensions, "KHR_materials_emissive_strength", "emissiveStrength", 1));
  if (source.emissiveTexture.index >= 0 && largest(m.emission) > 0.0f) {
    const auto mean = mean_of(source.emissiveTexture.index, part);
    m.emission = m.emission * (mean ? mean->linear : Vec3{0, 0, 0});
  }
  m.shininess = shininess_of(roughness);
  m.ior = 1.0f;

  if (source.extensions.contains("KHR_materials_unlit")) {
    // A texture multiplies ambient and diffuse only, so that a textured one needs light.
    (m.texture == kNoTexture ? m.emission : m.diffuse) = base;
    m.ambient = m.diffuse;
  } else {
    const float ior =
        static_cast<float>(std::clamp(number_of(source.extensions, "KHR_materials_ior", "ior", 1.5), 1.0, 10.0));
    const float facing = (ior - 1.0f) * (ior - 1.0f) / ((ior + 1.0f) * (ior + 1.0f));
    const float transmission =
        unit(number_of(source.extensions, "KHR_materials_transmission", "transmissionFactor", 0)) * (1.0f - metallic);
    // A rough surface mirrors nothing that one could see; without that a metal would be black, so it stays diffuse.
    const float mirror = std::max(0.0f, 1.0f - 2.0f * roughness);
    m.reflection = mirror * mixed({facing, facing, facing}, base, metallic);
    m.diffuse = (1.0f - transmission) * (1.0f - metallic * mirror) * base;
    m.specular = (1.0f - roughness) * mixed({0.3f, 0.3f, 0.3f}, base, metallic);
    m.transmission = transmission * (1.0f - facing) * base;
    if (transmission > 0.0f) m.ior = ior;
    m.ambient = m.diffuse;
  }
  if (source.alphaMode == "BLEND" && alpha < 1.0f) {
    m.ambient = alpha * m.ambient;
    m.diffuse = alpha * m.diffuse;
    m.emission = alpha * m.emission;
    m.transmission = mixed({1, 1, 1}, m.transmission, alpha);
  } else if (source.alphaMode != "OPAQUE" && m.texture != kNoTexture) {
    warn("alphaMode " + source.alphaMode + ": the alpha of its texture is not modelled");
  }
  if (!is_finite(m.emission) || std::min({m.emission.x, m.emission.y, m.emission.z}) < 0.0f) {
    document_.fail(part, "the emission is negative or not finite");
  }
  used.index = builder_.add_material(m);
  return used;
}

const tinygltf::Image& Materials::image_of(int texture, const std::string& part) const {
  const int source = document_.element(document_.model.textures, texture, "texture", part).source;
  return document_.element(document_.model.images, source, "image", "textures/" + std::to_string(texture));
}

/// Images that share their bytes share the name too.
std::string Materials::name_of(const tinygltf::Image& image) const {
  if (image.bufferView >= 0) return "bufferViews/" + std::to_string(image.bufferView);
  if (image.image.empty()) return percent_decoded(image.uri);
  return "images/" + std::to_string(&image - document_.model.images.data());
}

u32 Materials::texture(int index, const std::string& part) {
  const tinygltf::Image& image = image_of(index, part);
  const std::span<const u8> bytes = document_.bytes_of(image);
  if (!bytes.empty()) return builder_.add_texture(name_of(image), bytes, document_.at(part));
  return builder_.add_texture(name_of(image), {files_.main().parent_path()}, document_.at(part));
}

std::optional<Materials::Mean> Materials::mean_of(int texture, const std::string& part) {
  if (texture < 0) return std::nullopt;
  const tinygltf::Image& image = image_of(texture, part);
  const std::span<const u8> bytes_inside = document_.bytes_of(image);
  const std::string name = name_of(image);
  if (const auto known = means_.find(name); known != means_.end()) return known->second;
  try {
    Texture decoded;
    if (!bytes_inside.empty()) {
      decoded = files_.decode(bytes_inside);
    } else {
      const auto file = files_.find(name, files_.main().parent_path());
      if (!file) throw std::runtime_error("there is no texture " + in_quotes(name));
      const std::string bytes = files_.read(*file);
      decoded = files_.decode({reinterpret_cast<const u8*>(bytes.data()), bytes.size()});
    }
    std::array<std::array<u64, 256>, 3> histograms{};
    for (const u32 texel : decoded.texels) {
      for (u32 c = 0; c < 3; ++c) ++histograms[c][texel >> (8 * c) & 255];
    }
    std::array<double, 3> raw{}, linear{};
    for (u32 c = 0; c < 3; ++c) {
      for (u32 byte = 0; byte < 256; ++byte) {
        const double share = static_cast<double>(histograms[c][byte]) / static_cast<double>(decoded.texels.size());
        raw[c] += share * byte / 255.0;
        linear[c] += share * linear_of_srgb(byte);
      }
    }
    const auto vec = [](const std::array<double, 3>& v) {
      return Vec3{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
    };
    return means_[name] = Mean{vec(raw), vec(linear)};
  } catch (const std::runtime_error& e) {
    builder_.warn(document_.at(part), std::string(e.what()) + ": the texture's mean is unknown and left out");
    return means_[name] = std::nullopt;
  }
}

}  // namespace raywalk::gltf
