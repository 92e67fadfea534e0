// What Open Inventor hands from node to node.
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>

#include "kernels/scene_view.h"

namespace raywalk {

/// Which material or normal belongs to which part of a shape.
enum class IvBinding {
  kOverall,
  kPerPart,  // of face sets: a face; of strips: a strip
  kPerPartIndexed,
  kPerFace,
  kPerFaceIndexed,
  kPerVertex,
  kPerVertexIndexed,
};

/// Lists of the node that set them last; where a list is too short its last value goes on.
struct IvMaterials {
  std::span<const double> diffuse, specular, emission;  // triples
  std::span<const double> shininess, transparency;
};

struct IvState {
  glm::dmat4 transform{1.0};                     // to the world; for column vectors
  glm::dmat3 texture_transform{1.0};             // of (s, t, 1)
  std::span<const double> coordinates, normals;  // triples
  std::span<const double> texcoords;             // pairs, from the lower left corner
  IvMaterials materials;
  IvBinding material_binding = IvBinding::kOverall;
  std::optional<IvBinding> normal_binding;  // without: by vertex
  bool texcoords_indexed = true;
  u32 texture = kNoTexture;
  bool texture_replaces_color = false;
  double crease_angle = 0.0;  // radians: edges up to it are smooth where there are no normals
  bool visible = true;
  int switch_choice = -1;
};

}  // namespace raywalk
