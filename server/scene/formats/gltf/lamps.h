// Lights (KHR_lights_punctual) and cameras of a glTF file's nodes.
#pragma once
#include <glm/mat4x4.hpp>

#include "server/scene/formats/gltf/document.h"
#include "server/scene/scene_builder.h"

namespace raywalk::gltf {

class Lamps {
 public:
  Lamps(const Document& document, SceneBuilder& builder) : document_(document), builder_(builder) {}

  /// What the node has of both; `world` is its transform. Throws std::runtime_error about `part`.
  void add(const tinygltf::Node& node, const glm::dmat4& world, const std::string& part);
  /// The lights into the scene, when all geometry is known. The scene's do not fade with the distance: each gets the
  /// strength that it has in the middle of the scene, all scaled so that their squares sum to one.
  void finish();

 private:
  void add_light(const tinygltf::Light& light, const glm::dmat4& world, const std::string& part);
  void add_camera(const tinygltf::Node& node, const glm::dmat4& world, const std::string& part);

  struct Lamp {
    glm::dvec3 position;
    glm::dvec3 direction;  // of its rays
    bool far;              // its rays are parallel
    double intensity;      // candela, or lux if they are parallel
    Vec3 colour;
  };
  const Document& document_;
  SceneBuilder& builder_;
  std::vector<Lamp> lamps_;
};

}  // namespace raywalk::gltf
