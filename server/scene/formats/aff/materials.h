// The current fill of an AFF file and the materials made of fills and textures.
#pragma once
#include <array>
#include <map>
#include <string>

#include "server/scene/formats/aff/text.h"
#include "server/scene/scene_builder.h"

namespace raywalk::aff {

class Materials {
 public:
  explicit Materials(SceneBuilder& builder) : builder_(builder) {}

  /// After the word `f`: one colour with weights, as NFF has it.
  void read_fill(Text& text);
  /// After the word `fm`: ambient, diffuse and specular colours.
  void read_full_fill(Text& text);

  /// Index of the current fill without texture, and with one named in `text`.
  u32 plain();
  u32 textured(std::string_view image, const Text& text);

 private:
  using Key = std::array<u32, sizeof(Material) / sizeof(u32)>;
  void set(Text& text, Vec3 ambient, Vec3 diffuse, Vec3 specular);
  u32 index_of(u32 texture);

  SceneBuilder& builder_;
  Material fill_ = default_material();
  u32 plain_ = kUnknown;
  std::map<Key, u32> index_of_;
  std::map<std::string, u32> texture_of_;
  static constexpr u32 kUnknown = 0xffffffffu;
};

}  // namespace raywalk::aff
