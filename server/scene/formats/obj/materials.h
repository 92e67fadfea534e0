// Materials of MTL files, by name.
#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>

#include "server/scene/scene_builder.h"

namespace raywalk {

/// A material as an MTL file has it.
struct MtlMaterial {
  std::optional<Vec3> diffuse;        // Kd
  Vec3 specular{};                    // Ks
  std::optional<Vec3> filter;         // Tf
  Vec3 emission{};                    // Ke
  float exponent = 0.0f;              // Ns
  float ior = 1.0f;                   // Ni
  float opacity = 1.0f;               // d, 1 - Tr
  int illumination = -1;              // illum; -1 if the file has none
  std::string texture;                // map_Kd; empty for none
  std::string texture_place;          // its file and line
  std::filesystem::path folder;       // of the file that has the material
  std::optional<u32> scene_material;  // once a face has used it
};

/// In the one model, but for the texture. formats/README.md has the mapping.
Material whitted_material(const MtlMaterial& material);

class MtlLibrary {
 public:
  MtlLibrary(ImportFiles& files, SceneBuilder& builder) : files_(files), builder_(builder) {}

  /// Adds the materials of a file, the first time that it is named. Throws std::runtime_error naming file and line.
  void read(const std::filesystem::path& file);
  /// Index of the material in the scene; one that is not defined is the default one, with a warning the first time.
  u32 use(std::string_view name, const std::string& place);
  /// The material of faces without any.
  u32 default_index();

 private:
  void statement(std::string_view word, std::string_view rest, const std::string& place);
  void read_texture(std::string_view rest, const std::string& place);

  ImportFiles& files_;
  SceneBuilder& builder_;
  std::map<std::string, MtlMaterial, std::less<>> materials_;
  std::set<std::string, std::less<>> undefined_, unknown_;  // what there was a warning about
  std::set<std::filesystem::path> files_read_;
  MtlMaterial* current_ = nullptr;
  std::filesystem::path folder_;  // of the file that is being read
  std::optional<u32> default_index_;
};

}  // namespace raywalk
