// MTL statements, and what they become.
#include "server/scene/formats/obj/materials.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "server/scene/formats/obj/lines.h"

namespace raywalk {
namespace {

constexpr Vec3 kWhite{1, 1, 1};

// What the model has no place for, and what says the same once more.
constexpr std::array<std::string_view, 22> kNotModelled = {
    "Ka",     "Km",   "Pr",       "Pm",     "Ps",   "Pc",   "Pcr",  "aniso", "anisor", "sharpness", "map_Ka",
    "map_Ks", "bump", "map_bump", "map_Ke", "disp", "refl", "norm", "decal", "map_d",  "map_Bump",  "map_Ns"};

Vec3 clamped(Vec3 c) {
  return {std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f)};
}

/// One number for grey, or three; spectral curves and CIE colours are not read.
Vec3 color(std::string_view rest) {
  TokenReader words(rest);
  const std::string_view first = words.next();
  if (first == "spectral" || first == "xyz") {
    throw std::runtime_error("colours as '" + std::string(first) + "' are not supported");
  }
  TokenReader numbers(rest);
  if (words.next().empty()) {
    const float grey = finite_number(numbers);
    return {grey, grey, grey};
  }
  return finite_vector(numbers);
}

float number(std::string_view rest) {
  TokenReader words(rest);
  return finite_number(words);
}

bool is_number(std::string_view word) {
  float value = 0.0f;
  return parse_number(word, value);
}

}  // namespace

Material whitted_material(const MtlMaterial& mtl) {
  const int illum = mtl.illumination;
  const bool refracts = illum == 4 || illum == 6 || illum == 7 || illum == 9;
  const bool mirrors = illum >= 3 && illum <= 8;
  const float opacity = std::clamp(mtl.opacity, 0.0f, 1.0f);
  const Vec3 filter = clamped(mtl.filter.value_or(kWhite));

  Material m{};
  const Vec3 whole = mtl.texture.empty() ? default_material().diffuse : kWhite;
  m.diffuse = opacity * clamped(mtl.diffuse.value_or(whole));
  m.ambient = m.diffuse;
  if (illum != 0 && illum != 1) m.specular = clamped(mtl.specular);
  if (mirrors) m.reflection = m.specular;
  // Files without opacity say by illum 6 or 7 that the filter is meant; many opaque ones have illum 4 and a white one.
  const bool clear = opacity == 1.0f && mtl.filter && (illum == 6 || illum == 7);
  m.transmission = clear ? filter : (1.0f - opacity) * filter;
  m.emission = larger(mtl.emission, Vec3{0, 0, 0});
  m.shininess = std::max(mtl.exponent, 1.0f);
  m.ior = (refracts || illum < 0) && mtl.ior >= 0.1f ? mtl.ior : 1.0f;
  m.texture = kNoTexture;
  return m;
}

void MtlLibrary::read(const std::filesystem::path& file) {
  if (!files_read_.insert(file).second) return;
  const std::string text = files_.read(file);
  folder_ = file.parent_path();
  current_ = nullptr;
  ObjLines lines(text);
  for (std::string_view line; lines.next(line);) {
    TokenReader words(line);
    const std::string_view word = words.next();
    if (word.empty()) continue;
    const std::string_view rest = trimmed(line.substr(static_cast<size_t>(word.data() + word.size() - line.data())));
    try {
      statement(word, rest, at_line(file, lines.number()));
    } catch (const std::runtime_error& e) {
      throw std::runtime_error(at_line(file, lines.number()) + ": " + in_quotes(word) + ": " + e.what());
    }
  }
}

void MtlLibrary::statement(std::string_view word, std::string_view rest, const std::string& place) {
  if (word == "newmtl") {
    current_ = &(materials_[std::string(rest)] = {});
    current_->folder = folder_;
    return;
  }
  if (current_ == nullptr) throw std::runtime_error("there is no newmtl before it");
  MtlMaterial& m = *current_;
  if (word == "Kd") {
    m.diffuse = color(rest);
  } else if (word == "Ks") {
    m.specular = color(rest);
  } else if (word == "Tf") {
    m.filter = color(rest);
  } else if (word == "Ke") {
    m.emission = color(rest);
  } else if (word == "Ns") {
    m.exponent = number(rest);
  } else if (word == "Ni") {
    m.ior = number(rest);
  } else if (word == "d") {
    m.opacity = number(rest.starts_with("-halo") ? rest.substr(5) : rest);
  } else if (word == "Tr") {
    m.opacity = 1.0f - number(rest);
  } else if (word == "illum") {
    m.illumination = static_cast<int>(std::clamp(number(rest), 0.0f, 10.0f));
  } else if (word == "map_Kd") {
    read_texture(rest, place);
  } else if (std::find(kNotModelled.begin(), kNotModelled.end(), word) == kNotModelled.end() &&
             unknown_.emplace(word).second) {
    builder_.warn(place, "unknown statement " + in_quotes(word));
  }
}

void MtlLibrary::read_texture(std::string_view rest, const std::string& place) {
  while (rest.starts_with('-')) {
    TokenReader words(rest);
    const std::string_view option = words.next();
    std::string_view value = words.next();
    const bool numeric = is_number(value);
    while (numeric && is_number(value)) value = words.next();
    if (!numeric) value = words.next();
    rest = value.empty() ? std::string_view() : rest.substr(static_cast<size_t>(value.data() - rest.data()));
    builder_.warn(place, "option " + in_quotes(option) + " of the texture is ignored");
  }
  if (rest.empty()) throw std::runtime_error("the name of the image is missing");
  current_->texture = rest;
  current_->texture_place = place;
}

u32 MtlLibrary::use(std::string_view name, const std::string& place) {
  const auto found = materials_.find(name);
  if (found == materials_.end()) {
    if (undefined_.emplace(name).second) builder_.warn(place, "material " + in_quotes(name) + " is not defined");
    return default_index();
  }
  MtlMaterial& mtl = found->second;
  if (!mtl.scene_material) {
    Material material = whitted_material(mtl);
    if (!mtl.texture.empty()) material.texture = builder_.add_texture(mtl.texture, {mtl.folder}, mtl.texture_place);
    mtl.scene_material = builder_.add_material(material);
  }
  return *mtl.scene_material;
}

u32 MtlLibrary::default_index() {
  if (!default_index_) default_index_ = builder_.add_material(default_material());
  return *default_index_;
}

}  // namespace raywalk
