// Scenes by name: the catalogue's, loaded when asked for, and uploaded ones.
#pragma once
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/scene/catalog_files.h"

namespace raywalk {

/// A resident scene. Whoever holds it keeps it, evicted or not.
struct LoadedScene {
  SceneInfo info;
  bool uploaded = false;
  std::optional<u64> asked_triangles;  // what it was loaded for, of scenes that are generated
  std::shared_ptr<const Blob> blob;
  CameraPath camera_path;
  std::vector<NamedCamera> cameras;
  Box bounds;
  std::string content_sha256;
  std::vector<std::string> warnings;
  double load_ms = 0;
};

using ScenePtr = std::shared_ptr<const LoadedScene>;

/// A scene of the catalogue or an upload; `loaded` is null while it is not resident.
struct SceneEntry {
  SceneInfo info;
  ScenePtr loaded;
};

class Scenes {
 public:
  /// `on_change` is called with a name when what is resident under it has changed, and with what is there now (null:
  /// nothing).
  Scenes(std::filesystem::path scenes_dir, std::filesystem::path data_dir,
         std::function<void(const std::string&, const ScenePtr&)> on_change);

  std::vector<SceneEntry> list() const;
  /// Throws Refusal unknown_scene; `pointer` is where the request's body or query names the scene, empty if its path
  /// does.
  SceneEntry find(const std::string& name, const std::string& pointer = {}) const;
  /// Throws Refusal unknown_scene, or scene_not_loaded; `pointer` as for `find`.
  ScenePtr loaded(const std::string& name, const std::string& pointer = {}) const;

  struct Loading {
    ScenePtr scene;
    bool fresh;  // false: it was resident, or somebody else was loading it
  };
  /// Loads once, however many ask at the same time. Another triangle count replaces what is resident.
  /// Throws Refusal unknown_scene, invalid_triangles, bad_scene_data.
  Loading load(const std::string& name, std::optional<u64> triangles);
  /// What is resident under the name, whatever its triangle count; else loads the default. Throws as `load`.
  ScenePtr resident_or_load(const std::string& name);

  /// Replaces an earlier upload of that name. `extension` is that of the name which the file had (".obj"), or empty.
  /// Throws Refusal scene_name_taken, bad_mesh.
  ScenePtr upload(const std::string& name, const std::filesystem::path& file, const std::string& extension);

  /// Throws Refusal unknown_scene; a scene that is not resident stays so.
  void evict(const std::string& name);

  u64 resident_bytes() const;
  u64 resident_count() const;

 private:
  struct Slot {
    std::optional<u64> triangles;
    bool uploaded = false;
    std::shared_future<ScenePtr> scene;
    std::shared_ptr<Slot> before;  // what it replaces, in use until it is loaded
  };

  std::vector<std::string> known_names() const;
  [[noreturn]] void refuse_unknown(const std::string& name, const std::string& pointer) const;
  ScenePtr resident(const std::string& name) const;
  std::vector<ScenePtr> all_resident() const;
  ScenePtr load_now(const std::string& name, std::optional<u64> triangles) const;
  void take_back(const std::string& name, const std::shared_ptr<Slot>& slot);

  std::filesystem::path scenes_dir_, data_dir_;
  std::function<void(const std::string&, const ScenePtr&)> on_change_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Slot>> slots_;
};

}  // namespace raywalk
