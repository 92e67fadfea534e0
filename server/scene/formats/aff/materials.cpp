// Fills as materials of the Phong and Whitted model.
#include "server/scene/formats/aff/materials.h"

#include <algorithm>
#include <bit>

namespace raywalk::aff {
namespace {

Vec3 unit_range(Vec3 v) {
  return smaller(larger(v, Vec3{0, 0, 0}), Vec3{1, 1, 1});
}

}  // namespace

void Materials::read_fill(Text& text) {
  const Vec3 color = text.color("colour");
  const float diffuse = static_cast<float>(text.real("diffuse weight"));
  const float specular = static_cast<float>(text.real("specular weight"));
  // NFF knows no ambient light; a tenth keeps what is in shadow from being black.
  set(text, 0.1f * color, diffuse * color, {specular, specular, specular});
}

void Materials::read_full_fill(Text& text) {
  const Vec3 ambient = text.color("ambient colour"), diffuse = text.color("diffuse colour");
  set(text, ambient, diffuse, text.color("specular colour"));
}

void Materials::set(Text& text, Vec3 ambient, Vec3 diffuse, Vec3 specular) {
  const float shine = static_cast<float>(text.real("shine"));
  const float transmittance = std::clamp(static_cast<float>(text.real("transmittance")), 0.0f, 1.0f);
  const float ior = static_cast<float>(text.real("index of refraction"));
  const float mirrored = 1.0f - transmittance;  // light goes one way or the other, never both
  fill_ = Material{};
  fill_.ambient = unit_range(ambient);
  fill_.diffuse = unit_range(diffuse);
  fill_.specular = unit_range(specular);
  fill_.reflection = smaller(fill_.specular, {mirrored, mirrored, mirrored});
  fill_.transmission = {transmittance, transmittance, transmittance};
  fill_.shininess = std::max(shine, 1.0f);
  fill_.ior = ior > 0.0f ? ior : 1.0f;  // 0 where a file has nothing to say
  plain_ = kUnknown;
}

u32 Materials::plain() {
  if (plain_ == kUnknown) plain_ = index_of(kNoTexture);
  return plain_;
}

u32 Materials::textured(std::string_view image, const Text& text) {
  namespace fs = std::filesystem;
  const fs::path folder = text.file().parent_path();
  const auto [known, is_new] = texture_of_.try_emplace((folder / image).string());
  if (is_new) {
    known->second =
        builder_.add_texture(image, {folder, folder / "TextureFiles", folder / ".." / "TextureFiles"}, text.place());
  }
  return index_of(known->second);
}

u32 Materials::index_of(u32 texture) {
  Material material = fill_;
  material.texture = texture;
  const auto [known, is_new] = index_of_.try_emplace(std::bit_cast<Key>(material));
  if (is_new) known->second = builder_.add_material(material);
  return known->second;
}

}  // namespace raywalk::aff
