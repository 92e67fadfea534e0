// Collecting materials, textures and triangles within limits.
#include "server/scene/scene_builder.h"

#include <stdexcept>

#include "server/scene/text.h"
#include "server/scene/triangulate.h"

namespace raywalk {
namespace {

constexpr size_t kMostMaterials = 65'536;
constexpr size_t kMostWarnings = 100;
constexpr size_t kMostCorners = 1000;    // of one polygon: cutting ears is quadratic
constexpr u64 kMostTexels = 256u << 20;  // of all images together: 1 GiB
constexpr u32 kMagenta = 0xff | 0xff << 16, kBlack = 0;

}  // namespace

std::string at_line(const std::filesystem::path& file, u64 line) {
  return file.string() + ", line " + std::to_string(line);
}

SceneBuilder::SceneBuilder(ImportFiles& files) : files_(files), texels_left_(kMostTexels) {}

u32 SceneBuilder::add_material(const Material& material) {
  if (scene_.materials.size() == kMostMaterials) {
    throw std::runtime_error("more than " + std::to_string(kMostMaterials) + " materials");
  }
  scene_.materials.push_back(material);
  return static_cast<u32>(scene_.materials.size() - 1);
}

u32 SceneBuilder::add_texture(std::string_view name, std::initializer_list<std::filesystem::path> folders,
                              const std::string& place) {
  try {
    for (const std::filesystem::path& folder : folders) {
      const std::optional<std::filesystem::path> file = files_.find(name, folder);
      if (!file) continue;
      const std::string key = file->string();
      if (const auto known = texture_of_.find(key); known != texture_of_.end()) return known->second;
      const std::string bytes = files_.read(*file);
      return add_texture(key, std::span(reinterpret_cast<const u8*>(bytes.data()), bytes.size()), place);
    }
    warn(place, "there is no texture " + in_quotes(name) + ": a magenta checker takes its place");
  } catch (const std::runtime_error& e) {
    warn(place, std::string(e.what()) + ": a magenta checker takes its place");
  }
  return checker();
}

u32 SceneBuilder::add_texture(std::string_view name, std::span<const u8> bytes, const std::string& place) {
  if (const auto known = texture_of_.find(name); known != texture_of_.end()) return known->second;
  try {
    Texture texture = files_.decode(bytes);
    if (texture.texels.size() > texels_left_) {
      throw std::runtime_error("the textures have more than " + std::to_string(kMostTexels) + " texels");
    }
    texels_left_ -= texture.texels.size();
    texture.name = name;
    return keep(std::string(name), std::move(texture));
  } catch (const std::runtime_error& e) {
    warn(place,
         "texture '" + std::string(name) + "' cannot be read (" + e.what() + "): a magenta checker takes its place");
  }
  return texture_of_[std::string(name)] = checker();
}

u32 SceneBuilder::checker() {
  const std::string key = "(missing)";
  if (const auto known = texture_of_.find(key); known != texture_of_.end()) return known->second;
  Texture texture{key, 8, 8, {}};
  for (u32 i = 0; i < 64; ++i) texture.texels.push_back(((i % 8) + (i / 8)) % 2 == 0 ? kMagenta : kBlack);
  return keep(key, std::move(texture));
}

u32 SceneBuilder::keep(const std::string& key, Texture texture) {
  scene_.textures.push_back(std::move(texture));
  return texture_of_[key] = static_cast<u32>(scene_.textures.size() - 1);
}

u32 SceneBuilder::add_vertex(const MeshCorner& corner) {
  if (scene_.positions.size() == 0xffffffffu) throw std::runtime_error("more than 2^32 - 1 vertices");
  scene_.positions.push_back(corner.position);
  scene_.normals.push_back(corner.normal);
  scene_.texcoords.push_back(corner.texcoord);
  not_finite_ += !is_finite(corner.position);
  has_normals_ |= !(corner.normal == Vec3{0, 0, 0});
  has_texcoords_ |= corner.texcoord.s != 0.0f || corner.texcoord.t != 0.0f;
  return static_cast<u32>(scene_.positions.size() - 1);
}

void SceneBuilder::add_triangle(TriangleIndices triangle) {
  if (scene_.triangles.size() >= files_.limits().triangles) {
    throw std::runtime_error("more than " + std::to_string(files_.limits().triangles) + " triangles");
  }
  scene_.triangles.push_back(triangle);
}

void SceneBuilder::check_corners(size_t count) {
  if (count > kMostCorners) {
    throw std::runtime_error("a polygon of " + std::to_string(count) + " corners; the most is " +
                             std::to_string(kMostCorners));
  }
}

void SceneBuilder::add_polygon(std::span<const MeshCorner> corners, u32 material) {
  corners_.clear();
  for (const MeshCorner& corner : corners) corners_.push_back(add_vertex(corner));
  add_polygon(corners_, material);
}

void SceneBuilder::add_polygon(std::span<const u32> vertices, u32 material) {
  if (vertices.size() < 3) {
    ++not_faces_;
    return;
  }
  check_corners(vertices.size());
  if (vertices.size() == 3) return add_triangle({vertices[0], vertices[1], vertices[2], material});
  const std::vector<u32> cut = triangulate(vertices, scene_.positions);
  for (size_t i = 0; i < cut.size(); i += 3) add_triangle({cut[i], cut[i + 1], cut[i + 2], material});
}

void SceneBuilder::warn(const std::string& place, const std::string& message) {
  if (scene_.warnings.size() == kMostWarnings) {
    ++unshown_warnings_;
  } else {
    scene_.warnings.push_back(place + ": " + message);
  }
}

Scene SceneBuilder::finish() {
  const auto tell = [&](const std::string& text) { scene_.warnings.push_back(files_.main().string() + ": " + text); };
  if (unshown_warnings_ > 0) tell("and " + std::to_string(unshown_warnings_) + " warnings more");
  if (not_faces_ > 0) tell(std::to_string(not_faces_) + " faces with fewer than three corners are left out");
  if (not_finite_ > 0) tell(std::to_string(not_finite_) + " vertices are not finite: their triangles are never hit");
  if (scene_.materials.empty()) scene_.materials.push_back(default_material());
  if (!has_normals_) std::vector<Vec3>().swap(scene_.normals);
  if (!has_texcoords_) std::vector<TexCoord>().swap(scene_.texcoords);
  return std::move(scene_);
}

}  // namespace raywalk
