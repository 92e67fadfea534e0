// glTF 2.0, .gltf and .glb: the nodes of the scene with their meshes, materials, lights and cameras.
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <numeric>
#include <stdexcept>

#include "server/scene/formats/formats.h"
#include "server/scene/formats/gltf/accessor.h"
#include "server/scene/formats/gltf/lamps.h"
#include "server/scene/formats/gltf/material.h"

namespace raywalk {
namespace {

using gltf::Document;

/// Vertices and indices that a scene may name for each triangle that it may have: usual meshes need six.
constexpr u64 kWorkPerTriangle = 8;

Vec3 vec(glm::dvec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

glm::dvec3 vec_at(const std::vector<float>& values, size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

std::string numbered(const char* array, int index) {
  return std::string(array) + "/" + std::to_string(index);
}

/// The inverse transpose but for a positive factor; no division, so that a flattening transform is none to it.
glm::dmat3 normal_matrix(const glm::dmat4& m) {
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return glm::dot(x, cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

class GltfReader {
 public:
  explicit GltfReader(ImportFiles& files)
      : document_(gltf::open_document(files)),
        builder_(files),
        materials_(document_, files, builder_),
        lamps_(document_, builder_),
        work_left_(files.limits().triangles * kWorkPerTriangle) {}

  Scene read() {
    const std::string file = document_.file;
    if (!document_.model.animations.empty()) builder_.warn(file, "animations are left out");
    if (!document_.model.skins.empty()) builder_.warn(file, "skins are left out: skinned meshes keep their shape");
    visit_nodes();
    lamps_.finish();
    return builder_.finish();
  }

 private:
  struct Visit {
    int node;
    glm::dmat4 parent;
  };

  void visit_nodes() {
    const auto& nodes = document_.model.nodes;
    std::vector<bool> visited(nodes.size());
    std::vector<Visit> waiting;
    const std::vector<int> roots = root_nodes();
    for (size_t i = roots.size(); i-- > 0;) waiting.push_back({roots[i], glm::dmat4(1.0)});
    while (!waiting.empty()) {
      const Visit visit = waiting.back();
      waiting.pop_back();
      const std::string part = numbered("nodes", visit.node);
      const tinygltf::Node& node = document_.element(nodes, visit.node, "node", part);
      if (visited[static_cast<size_t>(visit.node)]) document_.fail(part, "has two parents, or is its own ancestor");
      visited[static_cast<size_t>(visit.node)] = true;
      const glm::dmat4 world = visit.parent * transform_of(node, part);
      if (node.mesh >= 0) add_mesh(node.mesh, world, part);
      lamps_.add(node, world, part);
      for (size_t i = node.children.size(); i-- > 0;) waiting.push_back({node.children[i], world});
    }
  }

  /// Those of the default scene, or the first one; without scenes all that are no children.
  std::vector<int> root_nodes() const {
    const tinygltf::Model& model = document_.model;
    if (!model.scenes.empty()) {
      return document_.element(model.scenes, std::max(model.defaultScene, 0), "scene", "scene").nodes;
    }
    std::vector<bool> is_child(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes) {
      for (const int child : node.children) {
        if (child >= 0 && static_cast<size_t>(child) < is_child.size()) is_child[static_cast<size_t>(child)] = true;
      }
    }
    std::vector<int> roots;
    for (size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
  }

  glm::dmat4 transform_of(const tinygltf::Node& node, const std::string& part) const {
    const auto check = [&](const std::vector<double>& values, size_t count, const char* name) {
      if (!values.empty() && values.size() != count) {
        document_.fail(part, std::string(name) + " has not " + std::to_string(count) + " numbers");
      }
      return !values.empty();
    };
    if (check(node.matrix, 16, "matrix")) return glm::make_mat4(node.matrix.data());
    glm::dmat4 m(1.0);
    if (check(node.rotation, 4, "rotation")) {
      const auto& q = node.rotation;  // x y z w
      const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      if (!(length > 0.0)) document_.fail(part, "the rotation is zero");
      m = glm::mat4_cast(glm::dquat(q[3] / length, q[0] / length, q[1] / length, q[2] / length));
    }
    if (check(node.scale, 3, "scale")) {
      for (int i = 0; i < 3; ++i) m[i] *= node.scale[static_cast<size_t>(i)];
    }
    if (check(node.translation, 3, "translation")) m[3] = {glm::make_vec3(node.translation.data()), 1.0};
    return m;
  }

  void add_mesh(int index, const glm::dmat4& world, const std::string& node_part) {
    const tinygltf::Mesh& mesh = document_.element(document_.model.meshes, index, "mesh", node_part);
    for (size_t i = 0; i < mesh.primitives.size(); ++i) {
      const std::string part = numbered("meshes", index) + "/primitives/" + std::to_string(i);
      try {
        add_primitive(mesh.primitives[i], world, part);
      } catch (const std::runtime_error& e) {  // the builder knows no file
        if (std::string_view(e.what()).starts_with(document_.file)) throw;
        document_.fail(part, e.what());
      }
    }
  }

  void add_primitive(const tinygltf::Primitive& primitive, const glm::dmat4& world, const std::string& part) {
    spend(1, part);
    const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode < TINYGLTF_MODE_POINTS || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      document_.fail(part, "the unknown mode " + std::to_string(mode));
    }
    const auto position = primitive.attributes.find("POSITION");
    if (mode < TINYGLTF_MODE_TRIANGLES || position == primitive.attributes.end()) {
      return builder_.warn(document_.at(part), "points, lines and what has no POSITION are left out");
    }
    if (!primitive.targets.empty()) builder_.warn(document_.at(part), "morph targets are left out");
    if (primitive.attributes.contains("COLOR_0")) builder_.warn(document_.at(part), "vertex colours are left out");

    const u64 count = gltf::value_count(document_, position->second, part);
    spend(count, part);
    const gltf::UsedMaterial& material = materials_.use(primitive.material, part);
    const u32 first = add_vertices(primitive, position->second, count, material, world, part);

    std::vector<u32> indices;
    if (primitive.indices >= 0) {
      spend(gltf::value_count(document_, primitive.indices, part), part);
      indices = gltf::read_indices(document_, primitive.indices, count, part);
    } else {
      indices.resize(count);
      std::iota(indices.begin(), indices.end(), 0u);
    }
    const bool mirrored = glm::dot(glm::cross(glm::dvec3(world[0]), glm::dvec3(world[1])), glm::dvec3(world[2])) < 0.0;
    add_triangles(mode, indices, first, material.index, mirrored);
  }

  u32 add_vertices(const tinygltf::Primitive& primitive, int position, u64 count, const gltf::UsedMaterial& material,
                   const glm::dmat4& world, const std::string& part) {
    const std::vector<float> positions = gltf::read_values(document_, position, 3, part);
    const auto optional = [&](const std::string& name, u32 components) {
      const auto found = primitive.attributes.find(name);
      if (found == primitive.attributes.end()) return std::vector<float>();
      if (gltf::value_count(document_, found->second, part) != count) {
        document_.fail(part, name + " has not as many values as POSITION");
      }
      return gltf::read_values(document_, found->second, components, part);
    };
    const std::vector<float> normals = optional("NORMAL", 3);
    const std::vector<float> texcoords = optional("TEXCOORD_" + std::to_string(material.texcoord_set), 2);
    const glm::dmat3 turn = normal_matrix(world);
    u32 first = 0;
    for (size_t i = 0; i < count; ++i) {
      MeshCorner corner{vec(world * glm::dvec4(vec_at(positions, i), 1.0)), {}, {}};
      if (!is_finite(corner.position)) {
        document_.fail(part, "vertex " + std::to_string(i) + " is moved beyond all numbers by its node");
      }
      if (!normals.empty()) {
        const glm::dvec3 normal = turn * vec_at(normals, i);
        const double length = glm::length(normal);
        if (length > 0.0 && std::isfinite(length)) corner.normal = vec(normal / length);
      }
      if (!texcoords.empty()) corner.texcoord = material.transform({texcoords[2 * i], texcoords[2 * i + 1]});
      if (!std::isfinite(corner.texcoord.s) || !std::isfinite(corner.texcoord.t)) {
        document_.fail(part, "texture coordinate " + std::to_string(i) + " is moved beyond all numbers");
      }
      const u32 index = builder_.add_vertex(corner);
      if (i == 0) first = index;
    }
    return first;
  }

  void add_triangles(int mode, const std::vector<u32>& indices, u32 first, u32 material, bool mirrored) {
    const auto add = [&](u32 a, u32 b, u32 c) {
      if (mirrored) std::swap(b, c);
      builder_.add_triangle({first + a, first + b, first + c, material});
    };
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      for (size_t i = 0; i + 2 < indices.size(); i += 3) add(indices[i], indices[i + 1], indices[i + 2]);
      return;
    }
    for (size_t i = 0; i + 2 < indices.size(); ++i) {
      const u32 a = mode == TINYGLTF_MODE_TRIANGLE_FAN ? indices[0] : indices[i];
      const u32 b = indices[i + 1], c = indices[i + 2];
      if (a == b || b == c || c == a) continue;  // joins strips
      const bool odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
      add(a, odd ? c : b, odd ? b : c);
    }
  }

  /// Instances multiply what a small file holds.
  void spend(u64 amount, const std::string& part) {
    if (amount > work_left_) {
      document_.fail(part, "the scene has far more vertices and indices than it may have triangles");
    }
    work_left_ -= amount;
  }

  Document document_;
  SceneBuilder builder_;
  gltf::Materials materials_;
  gltf::Lamps lamps_;
  u64 work_left_;
};

bool begins(std::span<const u8> head) {
  const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
  if (text.starts_with("glTF")) return true;
  const size_t first = text.find_first_not_of(" \t\r\n");
  return first != text.npos && text[first] == '{' && text.find("\"asset\"") != text.npos &&
         text.find("\"version\"") != text.npos;
}

Scene load(ImportFiles& files) {
  return GltfReader(files).read();
}

}  // namespace

extern const Format k_gltf_format;
const Format k_gltf_format{"glTF", {".gltf", ".glb"}, begins, load};

}  // namespace raywalk
