// Walks the nodes of Open Inventor files and builds the scene that they draw.
#pragma once
#include <functional>
#include <map>
#include <set>

#include "server/scene/formats/inventor/document.h"
#include "server/scene/formats/inventor/faces.h"
#include "server/scene/formats/inventor/fields.h"
#include "server/scene/formats/inventor/state.h"
#include "server/scene/scene_builder.h"
#include "server/scene/tessellate.h"

namespace raywalk {

class IvInterpreter {
 public:
  explicit IvInterpreter(ImportFiles& files) : files_(files), builder_(files) {}

  /// The whole scene. Throws std::runtime_error naming file and line.
  Scene read();

  using Visit = void (IvInterpreter::*)(const IvFields&);
  /// What to do at a node of this type; null if it is not known.
  static Visit visit_of(std::string_view type);

 private:
  /// A light without a place: seen from the scene its rays run along `direction`.
  struct DirectionalLight {
    glm::dvec3 direction;
    Vec3 intensity;
  };
  using TexcoordOf = std::function<glm::dvec2(const SurfaceSample&)>;

  // interpreter.cpp: groups, files, and how far USE may go.
  void file(const std::filesystem::path& path);
  void visit(const IvDocument& document, u32 node);
  void children(const IvFields& f);
  void group(const IvFields& f);
  void separator(const IvFields& f);
  void transform_separator(const IvFields& f);
  void switch_node(const IvFields& f);
  void first_child(const IvFields& f);
  void include(const IvFields& f);
  void nothing(const IvFields&) {}
  void warn_once(const IvFields& f, const std::string& what);
  void spend_values(u64 count);

  // transforms.cpp
  void move(const glm::dmat4& local) { state_.transform = state_.transform * local; }
  void matrix_transform(const IvFields& f);
  void translation(const IvFields& f);
  void rotation(const IvFields& f);
  void rotation_xyz(const IvFields& f);
  void scale(const IvFields& f);
  void transform(const IvFields& f);
  void texture_transform(const IvFields& f);

  // properties.cpp
  void material(const IvFields& f);
  void base_color(const IvFields& f);
  void packed_color(const IvFields& f);
  void packed_diffuse(const IvFields& f, std::string_view field);
  void material_binding(const IvFields& f);
  void normal_binding(const IvFields& f);
  void texcoord_binding(const IvFields& f);
  void coordinates(const IvFields& f);
  void normals(const IvFields& f);
  void texcoords(const IvFields& f);
  void shape_hints(const IvFields& f);
  void draw_style(const IvFields& f);
  void vertex_property(const IvFields& f);
  void texture(const IvFields& f);
  u32 inline_texture(const IvFields& f);
  /// Of the current state; an index beyond a list means its last one.
  u32 material_index(u64 index);

  // lights.cpp
  void point_light(const IvFields& f);
  void directional_light(const IvFields& f);
  void add_light(const IvFields& f, const Light& light);
  void place_directional_lights();
  void perspective_camera(const IvFields& f);
  void orthographic_camera(const IvFields& f);
  void add_camera(const IvFields& f, double height_angle);

  // face_sets.cpp
  void indexed_face_set(const IvFields& f);
  void face_set(const IvFields& f);
  void indexed_strips(const IvFields& f);
  void strips(const IvFields& f);
  void face_shape(const IvFields& f, bool indexed, bool strips);
  void draw_faces(const IvFields& f, const IvFaces& faces, bool strips);

  // solids.cpp
  void sphere(const IvFields& f);
  void cylinder(const IvFields& f);
  void cone(const IvFields& f);
  void cube(const IvFields& f);
  u32 part_material(u32 part);
  EmitTriangle emit_solid(u32 material, TexcoordOf texcoord_of);

  // corners.cpp
  /// A point of the current space as a corner of the scene; a zero normal is none. Throws if it is not finite there.
  MeshCorner corner(glm::dvec3 position, glm::dvec3 normal, glm::dvec2 texcoord) const;

  ImportFiles& files_;
  SceneBuilder builder_;
  IvState state_;
  std::map<std::filesystem::path, std::unique_ptr<const IvDocument>> documents_;
  std::vector<std::filesystem::path> open_files_;
  std::map<const IvNode*, u32> textures_;
  std::map<const IvField*, std::pair<std::vector<double>, std::vector<double>>> unpacked_;  // colours, transparencies
  std::map<std::string, u32> materials_;                                                    // by their bytes
  std::vector<DirectionalLight> directional_;
  std::set<std::string> told_;
  u32 depth_ = 0, lights_ = 0;
  u64 visits_left_ = 2'000'000;
  u64 values_left_ = 100'000'000;
};

}  // namespace raywalk
