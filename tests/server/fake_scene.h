// A scene of the tests: a name, a camera path, no triangles.
#pragma once
#include "server/catalog/structures.h"

namespace raywalk::test {

inline ScenePtr scene_named(const std::string& name) {
  auto scene = std::make_shared<LoadedScene>();
  scene->info.name = name;
  scene->info.triangles = 3;
  Blob blob(sizeof(SceneHeader));
  new (blob.data()) SceneHeader{};
  scene->blob = std::make_shared<const Blob>(std::move(blob));
  scene->camera_path = orbit_around(Box{});
  return scene;
}

}  // namespace raywalk::test
