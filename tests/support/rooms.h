// A small closed room with papered walls, a mirror ball, a glass ball and a pane under the lamps, to test shading with.
#pragma once
#include "kernels/shade/camera.h"
#include "tests/support/shaded_scene.h"

namespace raywalk::test {

struct RoomOptions {
  bool mirror = true, glass = true, specular = true;
  u32 lights = 3;
  bool texture = true;
};

/// Floor, walls and ceiling of a 4 x 3 x 4 box (material 0), a mirror ball that glows (1), a glass ball (2), a pane
/// (3).
inline Blob room(const RoomOptions& options) {
  Mesh box = subdivided_box(3);
  for (Corners& t : box)
    for (Vec3* p : {&t.a, &t.b, &t.c}) *p = *p * Vec3{2.0f, 1.5f, 2.0f};
  ShadedScene scene;
  scene.add(box, 0);
  scene.add(icosphere(2, 0.5f, {-0.8f, -0.9f, -0.5f}), 1);
  scene.add(icosphere(2, 0.5f, {0.7f, -0.8f, 0.2f}), 2);
  scene.add(Quad{{-1.6f, 0.9f, 1.0f}, {0.2f, 0.8f, 1.1f}, {0.3f, 0.5f, -0.9f}, {-1.5f, 0.6f, -1.0f}}, 3);

  const float shine = options.specular ? 0.5f : 0.0f, mirror = options.mirror ? 0.7f : 0.0f;
  scene.materials = {{.ambient = grey(0.2f), .diffuse = {0.7f, 0.6f, 0.5f}},
                     {.diffuse = grey(0.2f),
                      .specular = grey(shine),
                      .reflection = grey(mirror),
                      .emission = {0.03f, 0.02f, 0.0f},
                      .shininess = 40.0f},
                     {.diffuse = grey(0.1f),
                      .specular = grey(shine),
                      .reflection = grey(0.3f * mirror),
                      .transmission = options.glass ? Vec3{0.8f, 0.7f, 0.75f} : grey(0.0f),
                      .shininess = 80.0f,
                      .ior = 1.5f},
                     {.diffuse = grey(0.1f), .transmission = options.glass ? Vec3{0.3f, 0.9f, 0.6f} : grey(0.0f)}};
  scene.texcoords.clear();
  if (options.texture) {
    scene.images = {{kPaperWidth, kPaperHeight, {kPaper.begin(), kPaper.end()}}};
    scene.materials[0].texture = 0;
    for (const Corners& t : scene.mesh)
      for (const Vec3 p : {t.a, t.b, t.c})
        scene.texcoords.push_back({1.3f * p.x - 0.4f * p.y, 0.9f * p.y + 0.7f * p.z});
  }
  for (u32 l = 0; l < options.lights; ++l)
    scene.lights.push_back({{-1.2f + static_cast<float>(l), 1.2f, 0.8f}, grey(0.5f)});
  scene.background = {0.1f, 0.2f, 0.4f};
  scene.ambient = grey(0.5f);
  return pack_of(scene);
}

/// Inside the room, looking at the balls; for width x height pixels.
inline Camera room_camera(u32 width, u32 height) {
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  const float pixel = 1.4f / h;
  return {{0.1f, 0.2f, 1.8f}, {-0.5f * pixel * w, 0.45f, -1.0f}, {pixel, 0, 0}, {0, -pixel, 0}};
}

}  // namespace raywalk::test
