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
  /// Both outlive it. Reads the list of the daemon before, which stays in the store for the next start if this one
  /// fails.
  Residency(store::Store& store, const std::vector<KindInfo>& kinds);

  /// To be called once the daemon listens, before anything becomes resident: empties the store's list, so that what
  /// crashes the daemon again while it is restored is not tried a third time. Throws store::DatabaseError.
  void begin();

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
