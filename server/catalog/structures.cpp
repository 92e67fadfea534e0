// One build a key; everything that is handed out is a shared pointer.
#include "server/catalog/structures.h"

#include <spdlog/spdlog.h>

#include "server/system/refusal.h"

namespace raywalk {
namespace {

using State = StructureRecord::State;

/// `state` ready stands for "not there at all".
std::string why_not_built(const std::string& scene, const std::string& kind, State state, const std::string& error) {
  const std::string what = "Structure '" + kind + "' of scene '" + scene + "' is not built";
  if (state == State::building) return what + " yet: it is being built.";
  if (state == State::failed) return what + ": " + error;
  return what + "; build it with POST /v1/structures {\"scene\": \"" + scene + "\", \"kind\": \"" + kind + "\"}.";
}

[[noreturn]] void refuse_not_built(const std::string& scene, const std::string& kind, State state,
                                   const std::string& error, const std::string& pointer) {
  Refusal refusal(Refusal::Why::conflict, "structure_not_built", why_not_built(scene, kind, state, error));
  if (state == State::building) refusal.retryable();
  throw refusal.at(pointer);
}

}  // namespace

void Structures::build_now(Device& device, Entry& entry) {
  StructurePtr structure;
  std::string error;
  std::exception_ptr device_error;
  try {
    structure = device.build(entry.scene->blob, entry.record.kind, entry.record.options);
  } catch (const std::bad_alloc&) {
    error = "The daemon has not enough memory for it.";
  } catch (const OutOfDeviceMemory& e) {
    error = e.what();
    device_error = std::current_exception();
  } catch (const DeviceLost& e) {
    error = e.what();
    device_error = std::current_exception();
    queue_.tell_lost(e.what());
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (!error.empty()) spdlog::warn("building {} failed: {}", entry.record.id, error);
  const std::lock_guard lock(mutex_);
  entry.record.structure = std::move(structure);
  entry.record.state = error.empty() ? State::ready : State::failed;
  entry.record.error = std::move(error);
  entry.record.device_error = device_error;
  const auto found = entries_.find(entry.record.id);
  const bool evicted = found == entries_.end() || found->second.get() != &entry;
  if (entry.record.structure && !evicted) on_change_(entry.record);
}

Structures::EntryPtr Structures::start(const ScenePtr& scene, const std::string& kind_name, const GivenOptions& given) {
  const KindInfo& kind = kind_named(kinds_, kind_name, "/kind");
  auto entry = std::make_shared<Entry>();
  entry->scene = scene;
  StructureRecord& record = entry->record;
  record.options = complete_options(kind, given, "/options");
  record.id = structure_id(scene->info.name, kind, record.options);
  record.scene = scene->info.name;
  record.kind = kind.name;
  record.triangles = scene->info.triangles;

  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(record.id);
  if (found != entries_.end() && found->second->scene == scene && found->second->record.state != State::failed) {
    return found->second;
  }
  auto ended = std::make_shared<std::promise<void>>();
  entry->ended = ended->get_future().share();
  queue_.post([this, entry, ended](Device& device) {
    build_now(device, *entry);
    ended->set_value();
  });
  entries_[record.id] = entry;
  return entry;
}

StructureRecord Structures::build(const ScenePtr& scene, const std::string& kind, const GivenOptions& options) {
  const EntryPtr entry = start(scene, kind, options);
  const std::lock_guard lock(mutex_);
  return entry->record;
}

StructureRecord Structures::build_and_wait(const ScenePtr& scene, const std::string& kind,
                                           const GivenOptions& options) {
  const EntryPtr entry = start(scene, kind, options);
  entry->ended.get();
  const std::lock_guard lock(mutex_);
  if (entry->record.state == State::failed) {
    if (entry->record.device_error) std::rethrow_exception(entry->record.device_error);
    throw Refusal(Refusal::Why::conflict, "build_failed",
                  "Building '" + entry->record.id + "' failed: " + entry->record.error);
  }
  return entry->record;
}

std::vector<StructureRecord> Structures::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<StructureRecord> records;
  for (const auto& [id, entry] : entries_) records.push_back(entry->record);
  return records;
}

StructureRecord Structures::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  if (const auto found = entries_.find(id); found != entries_.end()) return found->second->record;
  Refusal refusal(Refusal::Why::unknown, "unknown_structure", "There is no structure '" + id + "'.");
  std::vector<std::string> ids;
  for (const auto& [known, unused] : entries_) ids.push_back(known);
  throw refusal.known(std::move(ids));
}

StructurePtr Structures::ready(const ScenePtr& scene, const std::string& ref, const std::string& pointer) const {
  const std::string& name = scene->info.name;
  const bool is_id = ref.find('.') != std::string::npos;
  if (is_id && !ref.starts_with(name + ".")) {
    throw Refusal(Refusal::Why::invalid, "foreign_structure", "Structure '" + ref + "' is not of scene '" + name + "'.")
        .at(pointer);
  }
  const std::string rest = is_id ? ref.substr(name.size() + 1) : ref;
  const KindInfo& kind = kind_named(kinds_, rest.substr(0, rest.find('.')), pointer);
  const std::string id = is_id ? ref : name + "." + ref;

  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(id);
  if (found == entries_.end() || found->second->scene != scene)
    refuse_not_built(name, kind.name, State::ready, "", pointer);
  const StructureRecord& record = found->second->record;
  if (record.device_error) std::rethrow_exception(record.device_error);
  if (record.state != State::ready) refuse_not_built(name, kind.name, record.state, record.error, pointer);
  return record.structure;
}

void Structures::evict(const std::string& id) {
  StructureRecord gone = find(id);
  gone.structure = nullptr;
  const std::lock_guard lock(mutex_);
  if (entries_.erase(id) > 0) on_change_(gone);
}

void Structures::evict_scene(const std::string& scene, const ScenePtr& keep) {
  const std::lock_guard lock(mutex_);
  std::erase_if(entries_,
                [&](const auto& item) { return item.second->record.scene == scene && item.second->scene != keep; });
}

u64 Structures::resident_bytes() const {
  u64 bytes = 0;
  for (const StructureRecord& record : list()) {
    if (record.structure) bytes += record.structure->stats().size_bytes;
  }
  return bytes;
}

u64 Structures::resident_count() const {
  u64 count = 0;
  for (const StructureRecord& record : list()) count += record.structure != nullptr;
  return count;
}

}  // namespace raywalk
