// From the space of a shape to the scene's.
#include <cmath>
#include <glm/geometric.hpp>

#include "server/scene/formats/inventor/interpreter.h"

namespace raywalk {

MeshCorner IvInterpreter::corner(glm::dvec3 position, glm::dvec3 normal, glm::dvec2 texcoord) const {
  const glm::dmat4& m = state_.transform;
  const glm::dvec3 p(m * glm::dvec4(position, 1.0));
  MeshCorner made;
  made.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  if (!is_finite(made.position)) throw std::runtime_error("transformed, a vertex is not finite");
  if (normal != glm::dvec3(0.0)) {
    // Cofactors: the inverse transposed up to its length, for flat matrices too.
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const glm::dvec3 yz = glm::cross(y, z);
    glm::dvec3 n = yz * normal.x + glm::cross(z, x) * normal.y + glm::cross(x, y) * normal.z;
    if (glm::dot(x, yz) < 0.0) n = -n;
    const double length = glm::length(n);
    if (std::isnormal(length)) {
      n /= length;
      made.normal = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    }
  }
  if (state_.texture == kNoTexture) return made;
  const glm::dvec3 st = state_.texture_transform * glm::dvec3(texcoord, 1.0);
  made.texcoord = {static_cast<float>(st.x), static_cast<float>(1.0 - st.y)};
  if (!std::isfinite(made.texcoord.s) || !std::isfinite(made.texcoord.t)) {
    throw std::runtime_error("transformed, a texture coordinate is not finite");
  }
  return made;
}

}  // namespace raywalk
