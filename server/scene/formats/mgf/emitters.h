// Surfaces that emit light, gathered into the few point lights of the model.
#pragma once
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "server/scene/scene_builder.h"

namespace raywalk {

/// A box in double.
struct Extent {
  glm::dvec3 lo{std::numeric_limits<double>::max()};
  glm::dvec3 hi{std::numeric_limits<double>::lowest()};
  void add(glm::dvec3 point);
  void add(const Extent& other);
  glm::dvec3 centre() const { return 0.5 * (lo + hi); }
  double diagonal() const;
};

/// Consecutive triangles of the scene that emit alike.
struct Emitter {
  u64 object = 0;  // those that touch each other in one object are one light
  bool two_sided = true;
  glm::dvec3 color{1.0};  // linear, of luminance 1
  double emitted = 0.0;   // lm/m2
  size_t first_triangle = 0, triangles = 0;
};

class MgfEmitters {
 public:
  /// The triangles are in the scene already.
  void add(const Emitter& emitter, const Scene& scene);
  /// Adds the lights, in the brightness that the model without attenuation wants. Many become few, with a warning that
  /// begins with `place`.
  void finish(SceneBuilder& builder, const std::string& place);

 private:
  struct Group {
    u64 object;
    bool two_sided;
    Extent extent;
    double area = 0.0;
    glm::dvec3 centre{0.0};  // times area
    glm::dvec3 normal{0.0};  // times area
    double power = 0.0;      // lm
    glm::dvec3 light{0.0};   // linear RGB, of that luminance
    std::vector<Emitter> parts;
  };
  static void join(Group& group, Group&& other);
  void join_nearest();
  static glm::dvec3 position_of(const Group& group, const Scene& scene, const Extent& room);

  std::vector<Group> groups_;
};

}  // namespace raywalk
