// A small closed room with a mirror ball and a glass ball, to test shading with.
#pragma once
#include "kernels/features.h"
#include "kernels/shade/camera.h"
#include "tests/support/meshes.h"

namespace raywalk::test {

struct RoomOptions {
  bool mirror = true, glass = true, specular = true;
  u32 lights = 3;
};

/// Floor, walls and ceiling of a 4 x 3 x 4 box (material 0), a mirror ball (1), a glass ball (2).
inline Blob room(const RoomOptions& options) {
  Mesh mesh = transformed(subdivided_box(3), 1.0f, {});
  for (Corners& t : mesh)
    for (Vec3* p : {&t.a, &t.b, &t.c}) *p = *p * Vec3{2.0f, 1.5f, 2.0f};
  std::vector<u32> materials(mesh.size(), 0);
  for (u32 ball = 1; ball <= 2; ++ball) {
    append(mesh, icosphere(2, 0.5f, ball == 1 ? Vec3{-0.8f, -0.9f, -0.5f} : Vec3{0.7f, -0.8f, 0.2f}));
    materials.resize(mesh.size(), ball);
  }
  BlobPlan plan(sizeof(SceneHeader));
  SceneHeader header{};
  header.corners = plan.add<Corners>(mesh.size());
  header.triangles = plan.add<TriangleIndices>(mesh.size());
  header.normals = plan.add<Vec3>(0);
  header.materials = plan.add<Material>(3);
  header.lights = plan.add<Light>(options.lights);
  header.background = {0.1f, 0.2f, 0.4f};
  header.ambient = {0.5f, 0.5f, 0.5f};
  if (options.specular) header.features |= kFeatureSpecular;
  if (options.mirror) header.features |= kFeatureReflection;
  if (options.glass) header.features |= kFeatureRefraction;
  if (options.lights > 1) header.features |= kFeatureManyLights;
  Blob blob = plan.allocate();
  std::memset(blob.data(), 0, blob.size_bytes());
  for (u32 i = 0; i < mesh.size(); ++i) {
    mesh[i].id = i;
    header.bounds.add(bounds_of(mesh[i]));
    slice_of(blob, header.corners)[i] = mesh[i];
    slice_of(blob, header.triangles)[i] = {3 * i, 3 * i + 1, 3 * i + 2, materials[i]};
  }
  const float shine = options.specular ? 0.5f : 0.0f, mirror = options.mirror ? 0.7f : 0.0f;
  const float glass = options.glass ? 0.8f : 0.0f;
  const auto out = slice_of(blob, header.materials);
  out[0] = {{0.2f, 0.2f, 0.2f}, {0.7f, 0.6f, 0.5f}, {}, {}, {}, 1.0f, 1.0f};
  out[1] = {{}, {0.2f, 0.2f, 0.2f}, {shine, shine, shine}, {mirror, mirror, mirror}, {}, 40.0f, 1.0f};
  out[2] = {{},
            {0.1f, 0.1f, 0.1f},
            {shine, shine, shine},
            {0.3f * mirror, 0.3f * mirror, 0.3f * mirror},
            {glass, glass, glass},
            80.0f,
            1.5f};
  for (u32 l = 0; l < options.lights; ++l)
    slice_of(blob, header.lights)[l] = {{-1.2f + static_cast<float>(l), 1.2f, 0.8f}, {0.5f, 0.5f, 0.5f}};
  std::memcpy(blob.data(), &header, sizeof header);
  return blob;
}

/// Inside the room, looking at the balls; for width x height pixels.
inline Camera room_camera(u32 width, u32 height) {
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  const float pixel = 1.4f / h;
  return {{0.1f, 0.2f, 1.8f}, {-0.5f * pixel * w, 0.45f, -1.0f}, {pixel, 0, 0}, {0, -pixel, 0}};
}

}  // namespace raywalk::test
