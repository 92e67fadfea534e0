// Notes, and the restoring.
#include "server/api/residency.h"

#include <spdlog/spdlog.h>

#include "server/api/wire.h"

namespace raywalk::api {
namespace {

/// A note that fails costs a restore, not the request that it belongs to.
template <class Work>
void noting(const std::string& what, const Work& work) {
  try {
    work();
  } catch (const store::DatabaseError& e) {
    spdlog::error("{} would not come back after a crash: {}", what, e.what());
  }
}

template <class Work>
void restoring(const std::string& what, const Work& work) {
  try {
    work();
    spdlog::info("{} is back after the crash", what);
  } catch (const std::exception& e) {
    spdlog::warn("{} does not come back after the crash: {}", what, e.what());
  }
}

}  // namespace

Residency::Residency(store::Store& store, const std::vector<KindInfo>& kinds) : store_(store), kinds_(kinds) {
  if (store_.crashed_before()) before_ = store_.resident();
}

void Residency::begin() {
  store_.forget_resident();
}

void Residency::scene_changed(const std::string& name, const ScenePtr& now) {
  noting("scene " + name, [&] {
    if (now && !now->uploaded) {
      store_.add_scene({name, now->asked_triangles});
    } else {
      store_.drop_scene(name);
    }
  });
}

void Residency::structure_changed(const StructureRecord& record) {
  noting("structure " + record.id, [&] {
    if (!record.structure) {
      store_.drop_structure(record.id);
      return;
    }
    store_.add_structure({record.id, record.scene, record.kind, to_json(record, kinds_).at("options").dump()});
  });
}

void Residency::restore(Scenes& scenes, Structures& structures, const std::stop_token& stop) {
  for (const store::ResidentScene& scene : before_.scenes) {
    if (stop.stop_requested()) return;
    restoring("scene " + scene.name, [&] { scenes.load(scene.name, scene.triangles); });
  }
  for (const store::ResidentStructure& structure : before_.structures) {
    if (stop.stop_requested()) return;
    restoring("structure " + structure.id, [&] {
      const ScenePtr scene = scenes.loaded(structure.scene);
      structures.build_and_wait(scene, structure.kind, parse_options(Json::parse(structure.options)));
    });
  }
}

}  // namespace raywalk::api
