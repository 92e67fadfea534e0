// glTF's metallic-roughness materials as Phong's and Whitted's.
#pragma once
#include <map>
#include <optional>

#include "server/scene/formats/gltf/document.h"
#include "server/scene/scene_builder.h"

namespace raywalk::gltf {

/// KHR_texture_transform: scaled, then turned counter-clockwise as one sees it, then moved.
struct TexcoordTransform {
  double offset_s = 0, offset_t = 0, rotation_rad = 0, scale_s = 1, scale_t = 1;

  TexCoord operator()(TexCoord uv) const;
};

/// What the primitives of a material need to know.
struct UsedMaterial {
  u32 index = 0;  // in the scene
  int texcoord_set = 0;
  TexcoordTransform transform{};
};

/// Converts a material when it is first used; the images of others are never decoded.
class Materials {
 public:
  Materials(const Document& document, ImportFiles& files, SceneBuilder& builder)
      : document_(document), files_(files), builder_(builder) {}

  /// `index` as a primitive has it: negative for none. Throws std::runtime_error about `part` for a wrong one.
  const UsedMaterial& use(int index, const std::string& part);

 private:
  UsedMaterial convert(const tinygltf::Material& source, const std::string& part);
  u32 texture(int index, const std::string& part);
  const tinygltf::Image& image_of(int texture, const std::string& part) const;
  std::string name_of(const tinygltf::Image& image) const;
  /// Mean bytes of an image, in [0, 1], and of what they mean as sRGB.
  struct Mean {
    Vec3 raw{}, linear{};
  };
  std::optional<Mean> mean_of(int texture, const std::string& part);

  const Document& document_;
  ImportFiles& files_;
  SceneBuilder& builder_;
  std::map<int, UsedMaterial> used_;
  std::map<std::string, std::optional<Mean>> means_;  // by the names of images
};

}  // namespace raywalk::gltf
