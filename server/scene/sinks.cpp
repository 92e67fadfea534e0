// Scene sink and streaming PLY writer.
#include "server/scene/sinks.h"

#include <cstring>
#include <stdexcept>

namespace raywalk {

void SceneSink::begin(MeshCounts counts) {
  scene_.positions.reserve(counts.vertices);
  scene_.normals.reserve(counts.vertices);
  scene_.triangles.reserve(counts.triangles);
}

u32 SceneSink::add_vertex(Vec3 position, Vec3 normal) {
  scene_.positions.push_back(position);
  scene_.normals.push_back(normal);
  return static_cast<u32>(scene_.positions.size() - 1);
}

void SceneSink::add_triangle(TriangleIndices triangle) {
  scene_.triangles.push_back(triangle);
}

void PlySink::begin(MeshCounts counts) {
  announced_ = counts;
  vertices_.open(path_, std::ios::binary | std::ios::trunc);
  faces_.open(path_, std::ios::binary | std::ios::in | std::ios::out);
  check(vertices_.is_open() && faces_.is_open(), "cannot be opened for writing");
  vertices_ << "ply\nformat binary_little_endian 1.0\ncomment made by raywalk-generate\n"
            << "element vertex " << counts.vertices << "\n"
            << "property float x\nproperty float y\nproperty float z\n"
            << "property float nx\nproperty float ny\nproperty float nz\n"
            << "element face " << counts.triangles << "\n"
            << "property list uchar uint vertex_indices\nproperty ushort material_index\nend_header\n";
  constexpr u64 kVertexBytes = 6 * sizeof(float);
  faces_.seekp(vertices_.tellp() + static_cast<std::streamoff>(counts.vertices * kVertexBytes));
  check(vertices_ && faces_, "cannot be written");
}

u32 PlySink::add_vertex(Vec3 position, Vec3 normal) {
  const float row[6] = {position.x, position.y, position.z, normal.x, normal.y, normal.z};
  vertices_.write(reinterpret_cast<const char*>(row), sizeof row);
  return static_cast<u32>(written_.vertices++);
}

void PlySink::add_triangle(TriangleIndices t) {
  char row[15] = {3};
  std::memcpy(row + 1, &t.a, 12);
  const unsigned short material = static_cast<unsigned short>(t.material);
  std::memcpy(row + 13, &material, sizeof material);
  faces_.write(row, sizeof row);
  ++written_.triangles;
}

void PlySink::finish() {
  vertices_.close();
  faces_.close();
  check(vertices_ && faces_, "cannot be written (is the disk full?)");
  check(written_.vertices == announced_.vertices && written_.triangles == announced_.triangles,
        "the generator gave other counts than it announced");
}

void PlySink::check(bool ok, const char* what) const {
  if (!ok) throw std::runtime_error(path_.string() + ": " + what);
}

}  // namespace raywalk
