// Nodes that set materials, lists, bindings and textures for what follows.
#include <algorithm>
#include <cstring>

#include "server/scene/formats/inventor/interpreter.h"
#include "server/scene/text.h"

namespace raywalk {
namespace {

constexpr double kLongestExponent = 128.0;  // of shininess 1

std::optional<IvBinding> binding_of(const IvFields& f, std::string_view field) {
  static constexpr std::pair<std::string_view, IvBinding> kBindings[] = {
      {"OVERALL", IvBinding::kOverall},      {"NONE", IvBinding::kOverall},
      {"PER_PART", IvBinding::kPerPart},     {"PER_PART_INDEXED", IvBinding::kPerPartIndexed},
      {"PER_FACE", IvBinding::kPerFace},     {"PER_FACE_INDEXED", IvBinding::kPerFaceIndexed},
      {"PER_VERTEX", IvBinding::kPerVertex}, {"PER_VERTEX_INDEXED", IvBinding::kPerVertexIndexed},
  };
  const std::string_view word = f.word(field);
  for (const auto& [name, binding] : kBindings) {
    if (name == word) return binding;
  }
  if (!word.empty() && word != "DEFAULT") f.fail(field, "unknown binding " + in_quotes(word));
  return std::nullopt;
}

/// The value at `index`, or the last one, or `otherwise` if there is none.
double at(std::span<const double> list, u64 index, double otherwise) {
  return list.empty() ? otherwise : list[std::min<u64>(index, list.size() - 1)];
}
Vec3 color_at(std::span<const double> list, u64 index, float otherwise) {
  if (list.empty()) return {otherwise, otherwise, otherwise};
  const double* c = list.data() + 3 * std::min<u64>(index, list.size() / 3 - 1);
  const auto clamped = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
  return {clamped(c[0]), clamped(c[1]), clamped(c[2])};
}

}  // namespace

void IvInterpreter::material(const IvFields& f) {
  IvMaterials& m = state_.materials;
  if (!f.ignored("diffuseColor")) m.diffuse = f.list("diffuseColor", 3);
  if (!f.ignored("specularColor")) m.specular = f.list("specularColor", 3);
  if (!f.ignored("emissiveColor")) m.emission = f.list("emissiveColor", 3);
  if (!f.ignored("shininess")) m.shininess = f.list("shininess", 1);
  if (!f.ignored("transparency")) m.transparency = f.list("transparency", 1);
}

void IvInterpreter::base_color(const IvFields& f) {
  if (!f.ignored("rgb")) state_.materials.diffuse = f.list("rgb", 3);
}

void IvInterpreter::packed_color(const IvFields& f) {
  if (f.find("orderedRGBA") != nullptr) {
    packed_diffuse(f, "orderedRGBA");
  } else if (f.find("rgba") != nullptr) {
    packed_diffuse(f, "rgba");
  }
}

void IvInterpreter::packed_diffuse(const IvFields& f, std::string_view field) {
  const auto [entry, added] = unpacked_.try_emplace(f.find(field));
  auto& [colors, transparencies] = entry->second;
  if (added) {
    for (const double value : f.list(field, 1)) {
      if (value < 0.0 || value > 0xffffffffu) f.fail(field, "a colour that has no 32 bits");
      const u32 rgba = static_cast<u32>(value);
      for (const int shift : {24, 16, 8}) colors.push_back((rgba >> shift & 0xff) / 255.0);
      transparencies.push_back(1.0 - (rgba & 0xff) / 255.0);
    }
  }
  state_.materials.diffuse = colors;
  state_.materials.transparency = transparencies;
}

void IvInterpreter::material_binding(const IvFields& f) {
  if (!f.ignored("value")) state_.material_binding = binding_of(f, "value").value_or(IvBinding::kOverall);
}

void IvInterpreter::normal_binding(const IvFields& f) {
  if (!f.ignored("value")) state_.normal_binding = binding_of(f, "value");
}

void IvInterpreter::texcoord_binding(const IvFields& f) {
  if (!f.ignored("value")) state_.texcoords_indexed = f.word("value") != "PER_VERTEX";
}

void IvInterpreter::coordinates(const IvFields& f) {
  if (!f.ignored("point")) state_.coordinates = f.list("point", 3);
}

void IvInterpreter::normals(const IvFields& f) {
  if (!f.ignored("vector")) state_.normals = f.list("vector", 3);
}

void IvInterpreter::texcoords(const IvFields& f) {
  if (!f.ignored("point")) state_.texcoords = f.list("point", 2);
}

void IvInterpreter::shape_hints(const IvFields& f) {
  const bool vrml = f.document().text.starts_with("#VRML");
  if (!f.ignored("creaseAngle")) state_.crease_angle = f.number("creaseAngle", vrml ? 0.5 : 0.0);
}

void IvInterpreter::draw_style(const IvFields& f) {
  if (!f.ignored("style")) state_.visible = f.word("style") != "INVISIBLE";
}

void IvInterpreter::vertex_property(const IvFields& f) {
  if (f.find("vertex") != nullptr) state_.coordinates = f.list("vertex", 3);
  if (f.find("texCoord") != nullptr) state_.texcoords = f.list("texCoord", 2);
  if (f.find("normal") != nullptr) {
    state_.normals = f.list("normal", 3);
    state_.normal_binding = binding_of(f, "normalBinding");
  }
  if (f.find("orderedRGBA") != nullptr) {
    packed_diffuse(f, "orderedRGBA");
    state_.material_binding = binding_of(f, "materialBinding").value_or(IvBinding::kOverall);
  }
}

void IvInterpreter::texture(const IvFields& f) {
  if (f.ignored("filename") || f.ignored("image")) return;
  const auto known = textures_.find(&f.node());
  if (known != textures_.end()) {
    state_.texture = known->second;
  } else {
    const std::string name = f.string("filename");
    const u32 index =
        name.empty() ? inline_texture(f) : builder_.add_texture(name, {f.document().file.parent_path()}, f.place());
    state_.texture = textures_[&f.node()] = index;
  }
  const std::string_view model = f.word("model");
  state_.texture_replaces_color = model == "DECAL" || model == "REPLACE";
}

u32 IvInterpreter::inline_texture(const IvFields& f) {
  const std::span<const double> image = f.list("image", 1);
  if (image.empty()) return kNoTexture;
  constexpr double kMostAcross = 65'536;
  const auto in_range = [&](size_t i, double most) { return i < image.size() && image[i] >= 0.0 && image[i] <= most; };
  if (!in_range(0, kMostAcross) || !in_range(1, kMostAcross) || !in_range(2, 4)) {
    f.fail("image", "width, height and a number of components up to 4 were expected");
  }
  const u32 width = static_cast<u32>(image[0]), height = static_cast<u32>(image[1]);
  const u32 components = static_cast<u32>(image[2]);
  const u64 texels = static_cast<u64>(width) * height;
  if (texels == 0 || components == 0) return kNoTexture;
  if (image.size() - 3 != texels) {
    f.fail("image", std::to_string(image.size() - 3) + " texels where " + std::to_string(width) + " x " +
                        std::to_string(height) + " were expected");
  }
  Texture texture{"inline image, " + f.place(), width, height, {}};
  texture.texels.reserve(texels);
  for (u32 y = height; y-- > 0;) {  // its rows run bottom up
    for (u32 x = 0; x < width; ++x) {
      const double value = image[3 + static_cast<u64>(y) * width + x];
      if (value < 0.0 || value > 0xffffffffu) f.fail("image", "a texel that has no 32 bits");
      u32 rgb = static_cast<u32>(value);
      if (components % 2 == 0) rgb >>= 8;  // the last byte is alpha
      const u32 red = components < 3 ? rgb & 0xff : rgb >> 16 & 0xff;
      const u32 green = components < 3 ? red : rgb >> 8 & 0xff;
      const u32 blue = rgb & 0xff;
      texture.texels.push_back(red | green << 8 | blue << 16);
    }
  }
  builder_.scene().textures.push_back(std::move(texture));
  return static_cast<u32>(builder_.scene().textures.size() - 1);
}

u32 IvInterpreter::material_index(u64 index) {
  const IvMaterials& list = state_.materials;
  const bool replaced = state_.texture != kNoTexture && state_.texture_replaces_color;
  const float transparency = static_cast<float>(std::clamp(at(list.transparency, index, 0.0), 0.0, 1.0));
  Material m{};
  m.diffuse = (1.0f - transparency) * (replaced ? Vec3{1, 1, 1} : color_at(list.diffuse, index, 0.8f));
  m.ambient = m.diffuse;
  m.specular = color_at(list.specular, index, 0.0f);
  m.transmission = {transparency, transparency, transparency};
  m.emission = color_at(list.emission, index, 0.0f);
  m.shininess =
      static_cast<float>(std::clamp(kLongestExponent * at(list.shininess, index, 0.2), 1.0, kLongestExponent));
  m.ior = 1.0f;
  m.texture = state_.texture;

  std::string bytes(sizeof(Material), '\0');
  std::memcpy(bytes.data(), &m, sizeof(Material));
  const auto [known, added] = materials_.try_emplace(std::move(bytes), 0);
  if (added) known->second = builder_.add_material(m);
  return known->second;
}

}  // namespace raywalk
