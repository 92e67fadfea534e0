// Face sets and strips, indexed or not, with what is bound to their parts.
#include <algorithm>
#include <cmath>
#include <utility>

#include "server/scene/formats/inventor/interpreter.h"

namespace raywalk {
namespace {

using glm::dvec2;
using glm::dvec3;

IvFaces indexed_faces(const IvFields& f, std::span<const double> coordinates) {
  const std::span<const double> indices = f.list("coordIndex", 1);
  const double count = static_cast<double>(coordinates.size() / 3);
  IvFaces faces;
  for (u32 slot = 0; slot < indices.size(); ++slot) {
    const double index = indices[slot];
    if (index != -1.0) {
      if (!(index >= 0.0 && index < count) || index != std::trunc(index)) {
        f.fail("coordIndex", "index " + decimal(index) + " is out of range: there are " +
                                 std::to_string(coordinates.size() / 3) + " points");
      }
      faces.corners.push_back({static_cast<u32>(index), slot, static_cast<u32>(faces.corners.size())});
    }
    const bool ends = index == -1.0 || slot + 1 == indices.size();
    if (ends && faces.corners.size() > (faces.ends.empty() ? 0 : faces.ends.back())) {
      faces.ends.push_back(faces.corners.size());
    }
  }
  return faces;
}

IvFaces counted_faces(const IvFields& f, std::span<const double> coordinates) {
  static constexpr double kRest[] = {-1.0};
  std::span<const double> counts = f.list("numVertices", 1);
  if (counts.empty()) counts = kRest;
  const u64 points = coordinates.size() / 3;
  u64 next = static_cast<u64>(std::max(f.integer("startIndex", 0), 0));
  IvFaces faces;
  for (const double count : counts) {
    const double left = static_cast<double>(points) - static_cast<double>(next);
    const double corners = count == -1.0 ? std::max(left, 0.0) : count;
    if (!(corners >= 0.0 && corners <= left) && corners > 0.0) {
      f.fail("numVertices", "index out of range: there are " + std::to_string(points) + " points");
    }
    if (corners < 0.0 || corners != std::trunc(corners)) f.fail("numVertices", "a count was expected");
    for (u64 end = next + static_cast<u64>(corners); next < end; ++next) {
      const u32 order = static_cast<u32>(faces.corners.size());
      faces.corners.push_back({static_cast<u32>(next), order, order});
    }
    faces.ends.push_back(faces.corners.size());
  }
  return faces;
}

/// Which element of a list belongs to a corner.
class Bound {
 public:
  Bound(const IvFields& f, const char* index_field, IvBinding binding, u64 count)
      : fields_(f), field_(index_field), binding_(binding), indices_(f.list(index_field, 1)), count_(count) {
    if (!indices_.empty() && indices_[0] < 0.0) indices_ = {};  // -1 stands for no list
  }

  /// May be beyond the list if the file has no indices for it.
  u64 at(const IvFaces::Corner& corner, u64 part, u64 face) const {
    switch (binding_) {
      case IvBinding::kOverall:
        return 0;
      case IvBinding::kPerPart:
        return part;
      case IvBinding::kPerPartIndexed:
        return index(part, part);
      case IvBinding::kPerFace:
        return face;
      case IvBinding::kPerFaceIndexed:
        return index(face, face);
      case IvBinding::kPerVertex:
        return corner.order;
      case IvBinding::kPerVertexIndexed:
        break;
    }
    return index(corner.slot, corner.coordinate);
  }
  u64 count() const { return count_; }

 private:
  u64 index(u64 place, u64 without_list) const {
    if (indices_.empty()) return without_list;
    if (place >= indices_.size()) fields_.fail(field_, "there are too few indices");
    const double value = indices_[place];
    if (!(value >= 0.0 && value < static_cast<double>(count_))) {
      fields_.fail(field_, "index " + decimal(value) + " is out of range: there are " + std::to_string(count_));
    }
    return static_cast<u64>(value);
  }

  const IvFields& fields_;
  const char* field_;
  IvBinding binding_;
  std::span<const double> indices_;
  u64 count_;
};

/// Texture coordinates where a file brings none: the longest side of the shape's box is s, the next one t.
class BoxMapping {
 public:
  BoxMapping(const IvFaces& faces, std::span<const double> coordinates) {
    dvec3 lo(1e300), hi(-1e300);
    for (const IvFaces::Corner& corner : faces.corners) {
      lo = glm::min(lo, triple(coordinates, corner.coordinate));
      hi = glm::max(hi, triple(coordinates, corner.coordinate));
    }
    const dvec3 size = hi - lo;
    int axes[] = {0, 1, 2};
    std::stable_sort(std::begin(axes), std::end(axes), [&](int a, int b) { return size[a] > size[b]; });
    s_ = axes[0];
    t_ = axes[1];
    origin_ = lo;
    length_ = size[s_] > 0.0 ? size[s_] : 1.0;
  }
  dvec2 at(dvec3 p) const { return {(p[s_] - origin_[s_]) / length_, (p[t_] - origin_[t_]) / length_}; }

 private:
  int s_ = 0, t_ = 1;
  dvec3 origin_{};
  double length_ = 1.0;
};

}  // namespace

void IvInterpreter::indexed_face_set(const IvFields& f) {
  face_shape(f, true, false);
}
void IvInterpreter::face_set(const IvFields& f) {
  face_shape(f, false, false);
}
void IvInterpreter::indexed_strips(const IvFields& f) {
  face_shape(f, true, true);
}
void IvInterpreter::strips(const IvFields& f) {
  face_shape(f, false, true);
}

void IvInterpreter::face_shape(const IvFields& f, bool indexed, bool strips) {
  if (!state_.visible) return;
  const IvState saved = state_;
  if (const IvField* property = f.find("vertexProperty"); property != nullptr && property->node != kNoNode) {
    const IvNode& node = f.document().nodes[property->node];
    if (node.type != "VertexProperty") f.fail("vertexProperty", "a VertexProperty was expected");
    vertex_property(IvFields(f.document(), node));
  }
  const IvFaces faces = indexed ? indexed_faces(f, state_.coordinates) : counted_faces(f, state_.coordinates);
  spend_values(faces.corners.size() + f.list(indexed ? "coordIndex" : "numVertices", 1).size());
  draw_faces(f, faces, strips);
  state_ = saved;
}

void IvInterpreter::draw_faces(const IvFields& f, const IvFaces& faces, bool strips) {
  const std::span<const double> points = state_.coordinates;
  const bool textured = state_.texture != kNoTexture;
  const u64 material_count = std::max<u64>(state_.materials.diffuse.size() / 3, 1);
  const Bound material(f, "materialIndex", state_.material_binding, material_count);
  const Bound normal(f, "normalIndex", state_.normal_binding.value_or(IvBinding::kPerVertexIndexed),
                     state_.normals.size() / 3);
  const Bound texcoord(f, "textureCoordIndex",
                       state_.texcoords_indexed ? IvBinding::kPerVertexIndexed : IvBinding::kPerVertex,
                       state_.texcoords.size() / 2);
  const BoxMapping mapping(textured && state_.texcoords.empty() ? faces : IvFaces(), points);
  std::vector<dvec3> smooth;
  if (state_.normals.empty() && state_.crease_angle > 0.0 && !strips) {
    smooth = smooth_normals(faces, points, state_.crease_angle);
  }
  if (state_.material_binding >= IvBinding::kPerVertex && material_count > 1) {
    warn_once(f, "materials by vertex: a face has that of its first corner");
  }

  const auto normal_at = [&](const IvFaces::Corner& corner, u64 part, u64 face) {
    if (!smooth.empty()) return smooth[corner.order];
    if (state_.normals.empty()) return dvec3(0.0);
    const u64 index = normal.at(corner, part, face);
    if (index < normal.count()) return triple(state_.normals, index);
    warn_once(f, "there are fewer normals than the binding needs: those corners have none");
    return dvec3(0.0);
  };
  const auto texcoord_at = [&](const IvFaces::Corner& corner) {
    if (!textured) return dvec2(0.0);
    if (state_.texcoords.empty()) return mapping.at(triple(points, corner.coordinate));
    const u64 index = texcoord.at(corner, 0, 0);
    if (index < texcoord.count()) return dvec2(state_.texcoords[2 * index], state_.texcoords[2 * index + 1]);
    warn_once(f, "there are fewer texture coordinates than the binding needs: those corners have none");
    return dvec2(0.0);
  };

  u64 last_material = ~0ull;
  u32 scene_material = 0;
  std::vector<MeshCorner> polygon;
  const auto draw = [&](std::span<const IvFaces::Corner> corners, u64 part, u64 face) {
    polygon.clear();
    for (const IvFaces::Corner& c : corners) {
      polygon.push_back(corner(triple(points, c.coordinate), normal_at(c, part, face), texcoord_at(c)));
    }
    if (corners.size() >= 3) {
      const u64 index = std::min(material.at(corners[0], part, face), material_count - 1);
      if (index != last_material) scene_material = material_index(last_material = index);
    }
    builder_.add_polygon(polygon, scene_material);
  };

  u64 triangles = 0;
  for (u32 part = 0; part < faces.count(); ++part) {
    const std::span<const IvFaces::Corner> corners = faces.face(part);
    if (!strips) {
      draw(corners, part, part);
      continue;
    }
    for (size_t i = 0; i + 2 < corners.size(); ++i, ++triangles) {
      const size_t odd = i % 2;  // every other triangle winds the other way
      const IvFaces::Corner triangle[] = {corners[i + odd], corners[i + 1 - odd], corners[i + 2]};
      draw(triangle, part, triangles);
    }
  }
}

}  // namespace raywalk
