// Corners of equal indices become one vertex of the scene.
#include "server/scene/formats/aff/mesh.h"

#include <array>

namespace raywalk::aff {
namespace {

class Mesh {
 public:
  Mesh(Text& text, Geometry& geometry, Materials& materials)
      : text_(text), geometry_(geometry), materials_(materials) {}

  void read() {
    text_.expect("vertices");
    read_points(points_, "vertices", "vertex");
    if (text_.peek() == "normals") {
      text_.word();
      read_points(normals_, "normals", "normal");
    }
    u32 material = 0;
    if (text_.peek() == "texturecoords") {
      text_.word();
      material = read_texcoords();
    } else {
      material = materials_.plain();
    }
    text_.expect("triangles");
    read_triangles(material);
  }

 private:
  /// One vertex of the scene; those of the same point are chained.
  struct Vertex {
    u32 normal, texcoord, index, next;
  };
  static constexpr u32 kNone = 0xffffffffu;
  static constexpr int kLongestSearch = 16;  // a point with more normals than that gets some vertices twice

  void read_points(std::vector<glm::dvec3>& points, const char* plural, const char* singular) {
    points.resize(text_.count(plural, 3));
    for (glm::dvec3& point : points) point = text_.point(singular);
  }

  u32 read_texcoords() {
    texcoords_.resize(text_.count("texture coordinates", 2));
    const u32 material = materials_.textured(text_.name("a texture"), text_);
    for (TexCoord& texcoord : texcoords_) {
      texcoord.s = static_cast<float>(text_.real("texture coordinate"));
      texcoord.t = static_cast<float>(text_.real("texture coordinate"));
    }
    return material;
  }

  std::array<u32, 3> read_indices(size_t count, const char* what) {
    std::array<u32, 3> indices;
    for (u32& index : indices) {
      const long long value = text_.integer(what);
      if (value < 0 || static_cast<unsigned long long>(value) >= count) {
        text_.fail(std::string(what) + " " + std::to_string(value) + " is out of range: there are " +
                   std::to_string(count));
      }
      index = static_cast<u32>(value);
    }
    return indices;
  }

  u32 vertex(u32 point, u32 normal, u32 texcoord) {
    u32 at = first_[point];
    for (int i = 0; i < kLongestSearch && at != kNone; ++i, at = vertices_[at].next) {
      if (vertices_[at].normal == normal && vertices_[at].texcoord == texcoord) return vertices_[at].index;
    }
    Corner corner{points_[point]};
    if (normal != kNone) corner.normal = normals_[normal];
    if (texcoord != kNone) corner.texcoord = texcoords_[texcoord];
    const u32 index = geometry_.add_vertex(corner);
    vertices_.push_back({normal, texcoord, index, first_[point]});
    first_[point] = static_cast<u32>(vertices_.size() - 1);
    return index;
  }

  void read_triangles(u32 material) {
    const size_t numbers = 3 + (normals_.empty() ? 0 : 3) + (texcoords_.empty() ? 0 : 3);
    first_.assign(points_.size(), kNone);
    for (size_t left = text_.count("triangles", numbers); left > 0; --left) {
      const std::array<u32, 3> p = read_indices(points_.size(), "vertex index");
      std::array<u32, 3> n{kNone, kNone, kNone}, t = n;
      if (!normals_.empty()) n = read_indices(normals_.size(), "normal index");
      if (!texcoords_.empty()) t = read_indices(texcoords_.size(), "texture coordinate index");
      const u32 a = vertex(p[0], n[0], t[0]), b = vertex(p[1], n[1], t[1]);
      geometry_.add_triangle(a, b, vertex(p[2], n[2], t[2]), material);
    }
  }

  Text& text_;
  Geometry& geometry_;
  Materials& materials_;
  std::vector<glm::dvec3> points_, normals_;
  std::vector<TexCoord> texcoords_;
  std::vector<u32> first_;  // of the chain of each point
  std::vector<Vertex> vertices_;
};

}  // namespace

void read_mesh(Text& text, Geometry& geometry, Materials& materials) {
  Mesh(text, geometry, materials).read();
}

}  // namespace raywalk::aff
