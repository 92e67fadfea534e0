// The small scenes that every device must agree on, and rays for each.
#pragma once
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/rooms.h"

namespace raywalk::test {

using SceneBlob = std::shared_ptr<const Blob>;

struct NamedScene {
  std::string name;
  SceneBlob scene;
};

inline std::vector<NamedScene> small_scenes() {
  const auto blob = [](Mesh mesh) { return std::make_shared<const Blob>(make_scene(std::move(mesh))); };
  Mesh broken = icosphere(1);
  broken[3].b.y = std::numeric_limits<float>::quiet_NaN();
  broken[7].a.x = std::numeric_limits<float>::infinity();
  Mesh twice = icosphere(1);
  append(twice, icosphere(1));
  return {{"empty", blob({})},
          {"one triangle", blob({triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0})})},
          {"soup", blob(random_soup(1, 600))},
          {"sphere", blob(icosphere(3))},
          {"box", blob(subdivided_box(6))},
          {"quad", blob(quad_grid(8))},
          {"slivers", blob(slivers(2, 300))},
          {"duplicates", blob(std::move(twice))},
          {"non-finite vertices", blob(std::move(broken))},
          {"small and far", blob(transformed(icosphere(2), 1e-3f, {100, -50, 25}))},
          {"room", std::make_shared<const Blob>(room({}))}};
}

/// Random rays, and rays at edges, at vertices and along axes.
inline std::vector<Ray> rays_for(const SceneBlob& scene) {
  const SceneView view{scene->data()};
  Mesh mesh;
  for (u32 i = 0; i < view.triangle_count(); ++i)
    if (is_finite(view.corners()[i])) mesh.push_back(view.corners()[i]);
  const Box bounds = mesh.empty() ? Box{{-1, -1, -1}, {1, 1, 1}} : bounds_of(mesh);
  std::vector<Ray> rays = random_rays(5, 700, bounds);
  if (mesh.empty()) return rays;
  for (const std::vector<Ray>& more : {edge_rays(6, 400, mesh), vertex_rays(7, 400, mesh), axis_rays(8, 400, mesh)})
    rays.insert(rays.end(), more.begin(), more.end());
  return rays;
}

}  // namespace raywalk::test
