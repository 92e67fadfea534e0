// Structures by id: built once for a key on the device thread, found for frames, evicted without harm to running work.
#pragma once
#include <exception>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/catalog/build_options.h"
#include "server/catalog/scenes.h"
#include "server/device/device_queue.h"

namespace raywalk {

using StructurePtr = std::shared_ptr<const Structure>;

/// A snapshot of one structure.
struct StructureRecord {
  enum class State { building, ready, failed };
  std::string id;
  std::string scene;
  std::string kind;
  OptionValues options;
  u64 triangles = 0;  // of the scene
  State state = State::building;
  std::string error;                // when failed
  std::exception_ptr device_error;  // when that was OutOfDeviceMemory or DeviceLost
  StructurePtr structure;           // when ready
};

class Structures {
 public:
  /// `kinds` outlives it. `on_change` is called with a structure that has become ready, and without its `structure`
  /// when it is evicted; those of an evicted scene go unnamed. It must not call back.
  Structures(
      DeviceQueue& queue, const std::vector<KindInfo>& kinds,
      std::function<void(const StructureRecord&)> on_change = [](const StructureRecord&) {})
      : queue_(queue), kinds_(kinds), on_change_(std::move(on_change)) {}

  const std::vector<KindInfo>& kinds() const { return kinds_; }

  /// Starts a build unless the structure is there or being built; a failed one is tried again.
  /// Throws Refusal for unknown kinds and bad options, DeviceBusy.
  StructureRecord build(const ScenePtr& scene, const std::string& kind, const GivenOptions& options);
  /// The same, and waits for the end. When it fails, throws OutOfDeviceMemory, DeviceLost, or Refusal build_failed.
  StructureRecord build_and_wait(const ScenePtr& scene, const std::string& kind, const GivenOptions& options);

  std::vector<StructureRecord> list() const;
  /// Throws Refusal unknown_structure.
  StructureRecord find(const std::string& id) const;
  /// `ref` is a kind (with its default options) or an id, and `pointer` where the request names it. Throws Refusal
  /// unknown_kind, foreign_structure, or structure_not_built; OutOfDeviceMemory or DeviceLost where the build did.
  StructurePtr ready(const ScenePtr& scene, const std::string& ref, const std::string& pointer) const;

  /// Throws Refusal unknown_structure.
  void evict(const std::string& id);
  /// Evicts the structures of scenes of that name other than `keep`, which may be null.
  void evict_scene(const std::string& scene, const ScenePtr& keep);

  u64 resident_bytes() const;
  u64 resident_count() const;

 private:
  struct Entry {
    StructureRecord record;
    ScenePtr scene;
    std::shared_future<void> ended;
  };
  using EntryPtr = std::shared_ptr<Entry>;

  EntryPtr start(const ScenePtr& scene, const std::string& kind, const GivenOptions& options);
  void build_now(Device& device, Entry& entry);

  DeviceQueue& queue_;
  const std::vector<KindInfo>& kinds_;
  std::function<void(const StructureRecord&)> on_change_;
  mutable std::mutex mutex_;
  std::map<std::string, EntryPtr> entries_;
};

}  // namespace raywalk
