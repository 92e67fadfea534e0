// Statements that make triangles.
#include <cstring>

#include "server/scene/formats/mgf/numbers.h"
#include "server/scene/formats/mgf/reader.h"

namespace raywalk {

/// Equal materials are one; scenes define the same one again and again.
u32 MgfReader::index_of(MgfMaterial& material) {
  if (material.index == MgfMaterial::kNotAdded) {
    static_assert(sizeof(Material) == 21 * sizeof(float), "no padding among the bytes");
    const Material made = phong_material(material);
    std::string bytes(sizeof(Material), '\0');
    std::memcpy(bytes.data(), &made, sizeof(Material));
    const auto known = index_of_.find(bytes);
    material.index = known != index_of_.end() ? known->second : builder_.add_material(made);
    index_of_.emplace(std::move(bytes), material.index);
  }
  return material.index;
}

/// Whatever `add` adds, in the current material, and its light.
template <class Add>
void MgfReader::surface(Add add) {
  MgfMaterial& material = materials_.current();
  geometry_.paint(index_of(material));
  const Scene& scene = builder_.scene();
  const size_t first = scene.triangles.size();
  add();
  if (material.emitted.amount > 0.0) {
    emitters_.add({objects_.empty() ? 0 : objects_.back(), material.two_sided, linear_rgb(material.emitted.color),
                   material.emitted.amount, first, scene.triangles.size() - first},
                  scene);
  }
}

std::span<const MgfVertex> MgfReader::corners(Words names) {
  corners_.clear();
  for (const std::string_view name : names) corners_.push_back(vertices_.named(name));
  return corners_;
}

void MgfReader::face(Words arguments) {
  surface([&] { geometry_.face(corners(arguments)); });
}

void MgfReader::sphere(Words arguments) {
  const MgfVertex& centre = vertices_.named(arguments[0]);
  surface([&] { geometry_.sphere(centre.position, mgf_number(arguments[1])); });
}

void MgfReader::cylinder(Words arguments) {
  const MgfVertex &base = vertices_.named(arguments[0]), &tip = vertices_.named(arguments[2]);
  const double radius = mgf_number(arguments[1]);
  surface([&] { geometry_.cone(base.position, radius, tip.position, radius); });
}

void MgfReader::cone(Words arguments) {
  const MgfVertex &base = vertices_.named(arguments[0]), &tip = vertices_.named(arguments[2]);
  const double base_radius = mgf_number(arguments[1]), tip_radius = mgf_number(arguments[3]);
  surface([&] { geometry_.cone(base.position, base_radius, tip.position, tip_radius); });
}

void MgfReader::ring(Words arguments) {
  const MgfVertex& centre = vertices_.named(arguments[0]);
  const double inner = mgf_number(arguments[1]), outer = mgf_number(arguments[2]);
  surface([&] { geometry_.ring(centre, inner, outer); });
}

void MgfReader::torus(Words arguments) {
  const MgfVertex& centre = vertices_.named(arguments[0]);
  const double inner = mgf_number(arguments[1]), outer = mgf_number(arguments[2]);
  surface([&] { geometry_.torus(centre, inner, outer); });
}

void MgfReader::prism(Words arguments) {
  const double length = mgf_number(arguments.back());
  surface([&] { geometry_.prism(corners(arguments.first(arguments.size() - 1)), length); });
}

}  // namespace raywalk
