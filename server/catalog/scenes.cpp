// Loading once, replacing, evicting.
#include "server/catalog/scenes.h"

#include <algorithm>
#include <chrono>

#include "server/image/decode_texture.h"
#include "server/scene/importer.h"
#include "server/system/refusal.h"

namespace raywalk {
namespace {

constexpr u64 kMaxTriangles = 100'000'000;

std::shared_ptr<LoadedScene> make_resident(Scene scene, SceneInfo info, bool uploaded,
                                           std::chrono::steady_clock::time_point begin) {
  if (scene.triangles.size() > kMaxTriangles) {
    throw std::runtime_error("the scene has " + std::to_string(scene.triangles.size()) + " triangles, more than " +
                             std::to_string(kMaxTriangles));
  }
  auto loaded = std::make_shared<LoadedScene>();
  info.triangles = scene.triangles.size();
  info.lights = static_cast<u32>(scene.lights.size());
  info.fidelity = scene.fidelity;
  info.fidelity_note = scene.fidelity_note;
  if (!scene.source.empty()) info.source = scene.source;
  info.frames = scene.camera_path.frames;
  loaded->info = std::move(info);
  loaded->uploaded = uploaded;
  loaded->bounds = bounds_of(scene);
  loaded->camera_path = scene.camera_path;
  loaded->cameras = scene.cameras;
  loaded->content_sha256 = scene.content_sha256;
  loaded->warnings = scene.warnings;
  if (scene.triangles.empty()) loaded->warnings.push_back("The scene has no triangles.");
  if (scene.lights.empty()) loaded->warnings.push_back("The scene has no lights: only ambient light is seen.");
  loaded->blob = std::make_shared<const Blob>(pack(scene));
  loaded->load_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return loaded;
}

bool is_ready(const std::shared_future<ScenePtr>& scene) {
  return scene.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

}  // namespace

Scenes::Scenes(std::filesystem::path scenes_dir, std::filesystem::path data_dir,
               std::function<void(const std::string&, const ScenePtr&)> on_change)
    : scenes_dir_(std::move(scenes_dir)), data_dir_(std::move(data_dir)), on_change_(std::move(on_change)) {}

ScenePtr Scenes::resident(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = slots_.find(name);
  if (found == slots_.end()) return nullptr;
  for (const Slot* slot = found->second.get(); slot != nullptr; slot = slot->before.get()) {
    if (!is_ready(slot->scene)) continue;
    try {
      return slot->scene.get();
    } catch (...) {  // it failed to load and is about to be dropped
    }
  }
  return nullptr;
}

std::vector<ScenePtr> Scenes::all_resident() const {
  std::vector<std::string> names;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [name, unused] : slots_) names.push_back(name);
  }
  std::vector<ScenePtr> scenes;
  for (const std::string& name : names) {
    if (ScenePtr scene = resident(name)) scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<SceneEntry> Scenes::list() const {
  std::vector<SceneEntry> entries;
  for (SceneInfo& info : list_scenes(scenes_dir_, data_dir_)) {
    ScenePtr loaded = resident(info.name);
    entries.push_back({loaded ? loaded->info : std::move(info), loaded});
  }
  for (ScenePtr& scene : all_resident()) {
    if (scene->uploaded) entries.push_back({scene->info, scene});
  }
  return entries;
}

std::vector<std::string> Scenes::known_names() const {
  std::vector<std::string> names;
  for (const SceneEntry& entry : list()) names.push_back(entry.info.name);
  return names;
}

void Scenes::refuse_unknown(const std::string& name, const std::string& pointer) const {
  Refusal refusal(Refusal::Why::unknown, "unknown_scene", "There is no scene '" + name + "'.");
  if (!pointer.empty()) refusal.at(pointer);
  throw refusal.known(known_names());
}

SceneEntry Scenes::find(const std::string& name, const std::string& pointer) const {
  for (SceneEntry& entry : list()) {
    if (entry.info.name == name) return std::move(entry);
  }
  refuse_unknown(name, pointer);
}

ScenePtr Scenes::loaded(const std::string& name, const std::string& pointer) const {
  if (ScenePtr scene = resident(name)) return scene;
  find(name, pointer);
  Refusal refusal(Refusal::Why::conflict, "scene_not_loaded",
                  "Scene '" + name + "' is not loaded; load it with POST /v1/scenes {\"name\": \"" + name + "\"}.");
  if (!pointer.empty()) refusal.at(pointer);
  throw refusal;
}

void Scenes::take_back(const std::string& name, const std::shared_ptr<Slot>& slot) {
  const std::lock_guard lock(mutex_);
  const auto found = slots_.find(name);
  if (found == slots_.end() || found->second != slot) return;
  if (slot->before) {
    found->second = slot->before;
  } else {
    slots_.erase(found);
  }
}

ScenePtr Scenes::load_now(const std::string& name, std::optional<u64> triangles) const {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<SceneInfo> all = list_scenes(scenes_dir_, data_dir_);
  const auto info = std::find_if(all.begin(), all.end(), [&](const SceneInfo& i) { return i.name == name; });
  if (info == all.end()) refuse_unknown(name, "/name");
  try {
    const std::shared_ptr<LoadedScene> scene = make_resident(
        load_scene(name, scenes_dir_, data_dir_, triangles, decode_texture), *info, /*uploaded=*/false, begin);
    scene->asked_triangles = triangles;
    return scene;
  } catch (const std::invalid_argument& e) {
    throw Refusal(Refusal::Why::invalid, "invalid_triangles", e.what()).at("/triangles");
  } catch (const std::runtime_error& e) {
    throw Refusal(Refusal::Why::invalid, "bad_scene_data", e.what()).at("/name");
  }
}

Scenes::Loading Scenes::load(const std::string& name, std::optional<u64> triangles) {
  std::promise<ScenePtr> promise;
  auto mine = std::make_shared<Slot>(Slot{triangles, false, promise.get_future().share(), nullptr});
  {
    std::unique_lock lock(mutex_);
    auto& slot = slots_[name];
    if (slot && (slot->triangles == triangles || slot->uploaded)) {
      const std::shared_ptr<Slot> other = slot;
      lock.unlock();
      return {other->scene.get(), false};
    }
    mine->before = slot;
    slot = mine;
  }
  try {
    promise.set_value(load_now(name, triangles));
  } catch (...) {
    take_back(name, mine);
    promise.set_exception(std::current_exception());
  }
  Loading loading{mine->scene.get(), true};
  {
    const std::lock_guard lock(mutex_);
    mine->before = nullptr;
  }
  on_change_(name, loading.scene);
  return loading;
}

ScenePtr Scenes::resident_or_load(const std::string& name) {
  if (ScenePtr scene = resident(name)) return scene;
  return load(name, std::nullopt).scene;
}

ScenePtr Scenes::upload(const std::string& name, const std::filesystem::path& file, const std::string& extension) {
  for (const SceneInfo& info : list_scenes(scenes_dir_, data_dir_)) {
    if (info.name == name) {
      throw Refusal(Refusal::Why::conflict, "scene_name_taken", "The catalogue has a scene '" + name + "' already.");
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  ScenePtr scene;
  try {
    // An upload is one file: whatever lies beside it belongs to somebody else.
    Scene mesh = load_mesh(file, {.root = file, .decode = decode_texture, .extension = extension});
    mesh.source = "upload";
    for (std::string& warning : mesh.warnings) warning = replaced(std::move(warning), file.string(), "upload");
    SceneInfo info;
    info.name = name;
    info.title = name;
    scene = make_resident(std::move(mesh), std::move(info), /*uploaded=*/true, begin);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw Refusal(Refusal::Why::invalid, "bad_mesh", replaced(e.what(), file.string(), "upload")).at("");
  }
  std::promise<ScenePtr> promise;
  promise.set_value(scene);
  bool replaces = false;
  {
    const std::lock_guard lock(mutex_);
    auto& slot = slots_[name];
    replaces = slot != nullptr;
    slot = std::make_shared<Slot>(Slot{std::nullopt, true, promise.get_future().share(), nullptr});
  }
  if (replaces) on_change_(name, scene);
  return scene;
}

void Scenes::evict(const std::string& name) {
  find(name);
  {
    const std::lock_guard lock(mutex_);
    const auto slot = slots_.find(name);
    if (slot == slots_.end() || !is_ready(slot->second->scene)) return;  // while it is loaded somebody waits for it
    slots_.erase(slot);
  }
  on_change_(name, nullptr);
}

u64 Scenes::resident_bytes() const {
  u64 bytes = 0;
  for (const ScenePtr& scene : all_resident()) bytes += scene->blob->size_bytes();
  return bytes;
}

u64 Scenes::resident_count() const {
  return all_resident().size();
}

}  // namespace raywalk
