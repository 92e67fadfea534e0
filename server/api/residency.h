// What is resident, noted in the store, so that it comes back after a crash.
#pragma once
#include <stop_token>
#include <string>
#include <vector>

#include "server/catalog/scenes.h"
#include "server/catalog/structures.h"
#include "server/store/store.h"

namespace raywalk::api {

/// Scenes of the catalogue and structures of theirs; uploads are gone with their daemon. From any thread.
class Residency {
 public:
  /// Both outlive it. Takes the list of the daemon before out of the store at once: what crashes the daemon again while
  /// it is restored is not tried a third time.
  Residency(store::Store& store, const std::vector<KindInfo>& kinds);

  /// As Scenes and Structures tell it.
  void scene_changed(const std::string& name, const ScenePtr& now);
  void structure_changed(const StructureRecord& record);

  /// Loads and builds what was resident when the daemon before crashed, one after the other, until `stop`. What fails
  /// is logged. Nothing after a stop in good order.
  void restore(Scenes& scenes, Structures& structures, const std::stop_token& stop);

 private:
  store::Store& store_;
  const std::vector<KindInfo>& kinds_;
  store::Resident before_;
};

}  // namespace raywalk::api
