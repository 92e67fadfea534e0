// The mapping of materials.
#include "server/scene/formats/mgf/material.h"

#include <algorithm>
#include <cmath>

namespace raywalk {
namespace {

constexpr double kMostShininess = 1000.0;
constexpr double kMirrorRoughness = 0.2;   // from here on nothing is mirrored
constexpr double kLeastReflection = 0.02;  // less is not worth the rays
constexpr double kLeastSpecular = 1.0 / 512;

/// `amount` of the colour, no component above 1.
Vec3 tinted(const MgfColor& color, double amount) {
  const glm::dvec3 rgb = linear_rgb(color) * std::max(amount, 0.0);
  const double scale = 1.0 / std::max({rgb.r, rgb.g, rgb.b, 1.0});
  return {static_cast<float>(rgb.r * scale), static_cast<float>(rgb.g * scale), static_cast<float>(rgb.b * scale)};
}

}  // namespace

Material phong_material(const MgfMaterial& material) {
  Material m{};
  m.texture = kNoTexture;
  m.diffuse = m.ambient = tinted(material.diffuse.color, material.diffuse.amount);

  const MgfMaterial::Term& mirror = material.specular;
  const double roughness = std::abs(mirror.roughness);
  m.shininess = static_cast<float>(std::clamp(2.0 / (roughness * roughness), 1.0, kMostShininess));
  // A lamp's image in a smooth surface is far brighter than its share of the light tells; the root comes near it.
  if (mirror.amount > kLeastSpecular) m.specular = tinted(mirror.color, std::sqrt(mirror.amount));
  const double sharp = std::max(1.0 - roughness / kMirrorRoughness, 0.0);
  if (const double mirrored = mirror.amount * sharp * sharp; mirrored > kLeastReflection) {
    m.reflection = tinted(mirror.color, mirrored);
  }

  m.transmission = tinted(material.transparent.color, material.transparent.amount) +
                   tinted(material.translucent.color, material.translucent.amount);
  m.transmission = smaller(m.transmission, Vec3{1, 1, 1});
  // A surface with two sides is a thin pane: light goes straight on.
  m.ior = material.two_sided ? 1.0f : static_cast<float>(std::clamp(material.ior, 1.0, 4.0));

  if (material.emitted.amount > 0.0) m.emission = tinted(material.emitted.color, 1.0);
  return m;
}

}  // namespace raywalk
