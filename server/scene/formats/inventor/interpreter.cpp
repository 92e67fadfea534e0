// Groups, included files, and the table of nodes.
#include "server/scene/formats/inventor/interpreter.h"

#include <algorithm>
#include <utility>

#include "server/scene/text.h"

namespace raywalk {
namespace {

constexpr u32 kDeepest = 400;  // nodes one inside the other, through USE and files too

}  // namespace

IvInterpreter::Visit IvInterpreter::visit_of(std::string_view type) {
  using I = IvInterpreter;
  static const std::map<std::string_view, Visit> kVisits = {
      {"Separator", &I::separator},
      {"Annotation", &I::separator},
      {"Selection", &I::separator},
      {"ExtSelection", &I::separator},
      {"LocateHighlight", &I::separator},
      {"WWWAnchor", &I::separator},
      {"TransformSeparator", &I::transform_separator},
      {"Group", &I::group},
      {"Switch", &I::switch_node},
      {"LOD", &I::first_child},
      {"LevelOfDetail", &I::first_child},
      {"File", &I::include},
      {"MatrixTransform", &I::matrix_transform},
      {"Translation", &I::translation},
      {"Rotation", &I::rotation},
      {"RotationXYZ", &I::rotation_xyz},
      {"Scale", &I::scale},
      {"Transform", &I::transform},
      {"Texture2Transform", &I::texture_transform},
      {"Material", &I::material},
      {"BaseColor", &I::base_color},
      {"PackedColor", &I::packed_color},
      {"MaterialBinding", &I::material_binding},
      {"NormalBinding", &I::normal_binding},
      {"TextureCoordinateBinding", &I::texcoord_binding},
      {"Coordinate3", &I::coordinates},
      {"Normal", &I::normals},
      {"TextureCoordinate2", &I::texcoords},
      {"ShapeHints", &I::shape_hints},
      {"DrawStyle", &I::draw_style},
      {"Texture2", &I::texture},
      {"VertexProperty", &I::vertex_property},
      {"PointLight", &I::point_light},
      {"SpotLight", &I::point_light},
      {"DirectionalLight", &I::directional_light},
      {"PerspectiveCamera", &I::perspective_camera},
      {"OrthographicCamera", &I::orthographic_camera},
      {"IndexedFaceSet", &I::indexed_face_set},
      {"FaceSet", &I::face_set},
      {"IndexedTriangleStripSet", &I::indexed_strips},
      {"TriangleStripSet", &I::strips},
      {"Sphere", &I::sphere},
      {"Cylinder", &I::cylinder},
      {"Cone", &I::cone},
      {"Cube", &I::cube},
      // Nothing of these is to be seen in an image of ours.
      {"Info", &I::nothing},
      {"Label", &I::nothing},
      {"Complexity", &I::nothing},
      {"PickStyle", &I::nothing},
      {"Font", &I::nothing},
      {"FontStyle", &I::nothing},
      {"Environment", &I::nothing},
  };
  const auto found = kVisits.find(type);
  return found == kVisits.end() ? nullptr : found->second;
}

bool is_known_inventor_node(std::string_view type) {
  return IvInterpreter::visit_of(type) != nullptr;
}

Scene IvInterpreter::read() {
  file(files_.main());
  place_directional_lights();
  // Files with lights of their own have no other word for what lights their shadows.
  if (lights_ > 0) builder_.scene().ambient = {0.12f, 0.12f, 0.12f};
  if (builder_.scene().triangles.empty()) builder_.warn(files_.main().string(), "the file draws no faces");
  return builder_.finish();
}

void IvInterpreter::file(const std::filesystem::path& path) {
  std::unique_ptr<const IvDocument>& document = documents_[path];
  if (!document) document = parse_inventor(path, files_.read(path));
  open_files_.push_back(path);
  for (const u32 root : document->roots) visit(*document, root);
  open_files_.pop_back();
}

void IvInterpreter::visit(const IvDocument& document, u32 index) {
  const IvNode& node = document.nodes[index];
  const IvFields f(document, node);
  try {
    if (visits_left_-- == 0) throw std::runtime_error("USE makes more than two million nodes of the file's");
    if (depth_ == kDeepest) throw std::runtime_error("nodes more than " + std::to_string(kDeepest) + " deep, by USE");
    ++depth_;
    if (const Visit known = visit_of(node.type)) {
      (this->*known)(f);
    } else {
      warn_once(f, "nodes of type " + in_quotes(node.type) + " are skipped");
    }
    --depth_;
  } catch (const PlacedError&) {
    throw;
  } catch (const std::runtime_error& e) {
    throw PlacedError(f.place() + ": " + e.what());
  }
}

void IvInterpreter::spend_values(u64 count) {
  if (count > values_left_) throw std::runtime_error("USE makes more than a hundred million indices of the file's");
  values_left_ -= count;
}

void IvInterpreter::warn_once(const IvFields& f, const std::string& what) {
  if (told_.insert(what).second) builder_.warn(f.place(), what);
}

void IvInterpreter::children(const IvFields& f) {
  for (const u32 child : f.node().children) visit(f.document(), child);
}

void IvInterpreter::group(const IvFields& f) {
  children(f);
}

void IvInterpreter::separator(const IvFields& f) {
  const IvState saved = state_;
  children(f);
  state_ = saved;
}

void IvInterpreter::transform_separator(const IvFields& f) {
  const glm::dmat4 saved = state_.transform;
  children(f);
  state_.transform = saved;
}

void IvInterpreter::switch_node(const IvFields& f) {
  constexpr int kNone = -1, kInherit = -2, kAll = -3;
  const std::vector<u32>& nodes = f.node().children;
  const int choice = f.integer("whichChild", kNone);
  const int outer = state_.switch_choice;
  if (choice != kInherit) state_.switch_choice = choice;
  const int chosen = state_.switch_choice;
  if (chosen == kAll) {
    children(f);
  } else if (chosen >= 0 && !nodes.empty()) {
    const u64 which = static_cast<u64>(chosen);
    if (choice == kInherit) {
      visit(f.document(), nodes[which % nodes.size()]);
    } else if (which < nodes.size()) {
      visit(f.document(), nodes[which]);
    } else {
      f.fail("whichChild", "there is no child " + std::to_string(chosen));
    }
  }
  state_.switch_choice = outer;
}

void IvInterpreter::first_child(const IvFields& f) {
  if (!f.node().children.empty()) visit(f.document(), f.node().children.front());
}

void IvInterpreter::include(const IvFields& f) {
  const std::string name = f.string("name");
  if (name.empty()) return warn_once(f, "a File node without a name is skipped");
  const auto path = files_.find(name, f.document().file.parent_path());
  if (!path) f.fail("name", "there is no file " + in_quotes(name));
  if (std::find(open_files_.begin(), open_files_.end(), *path) != open_files_.end()) {
    f.fail("name", in_quotes(name) + " includes itself");
  }
  file(*path);
}

}  // namespace raywalk
