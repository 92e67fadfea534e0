// Scenes: list, load, upload, evict, pin, cameras.
#include "server/api/handlers.h"
#include "server/api/wire.h"

namespace raywalk::api {
namespace {

Json scene_json(Services& s, const SceneEntry& entry) {
  Json json = to_json(entry);
  json["pinned"] = s.pins.has(entry.info.name);
  return json;
}

Json scene_json(Services& s, const ScenePtr& scene) {
  return scene_json(s, SceneEntry{scene->info, scene});
}

/// Another triangle count would replace what is resident.
void refuse_to_replace_pinned(Services& s, const std::string& name, std::optional<u64> triangles) {
  const ScenePtr now = s.scenes.find(name, "/name").loaded;
  if (now && !now->uploaded && now->asked_triangles != triangles) s.pins.refuse(name);
}

}  // namespace

Response list_scenes(Services& s, const Request&) {
  Json scenes = Json::array();
  for (const SceneEntry& entry : s.scenes.list()) scenes.push_back(scene_json(s, entry));
  return http::json_response({{"scenes", scenes}});
}

Response load_scene(Services& s, const Request& r) {
  std::optional<u64> triangles;
  if (r.json.contains("triangles")) triangles = r.json.at("triangles").get<u64>();
  refuse_to_replace_pinned(s, r.json.at("name"), triangles);
  const Scenes::Loading loading = s.scenes.load(r.json.at("name"), triangles);
  return http::json_response(scene_json(s, loading.scene), loading.fresh ? 201 : 200);
}

Response get_scene(Services& s, const Request& r) {
  return http::json_response(scene_json(s, s.scenes.find(r.path_parameter("scene"))));
}

Response upload_scene(Services& s, const Request& r) {
  const std::string extension = r.query.contains("extension") ? "." + r.query.at("extension").get<std::string>() : "";
  s.pins.refuse(r.path_parameter("scene"));
  return http::json_response(scene_json(s, s.scenes.upload(r.path_parameter("scene"), r.file, extension)), 201);
}

Response delete_scene(Services& s, const Request& r) {
  s.pins.refuse(r.path_parameter("scene"));
  s.scenes.evict(r.path_parameter("scene"));
  return http::no_content();
}

Response pin_scene(Services& s, const Request& r) {
  s.pins.add(s.scenes.loaded(r.path_parameter("scene"))->info.name);
  return http::no_content();
}

Response unpin_scene(Services& s, const Request& r) {
  s.pins.remove(s.scenes.find(r.path_parameter("scene")).info.name);
  return http::no_content();
}

Response list_cameras(Services& s, const Request& r) {
  const ScenePtr scene = s.scenes.loaded(r.path_parameter("scene"));
  const u32 frames = r.query.at("frames");
  Json cameras = Json::array();
  for (u32 i = 0; i < frames; ++i) cameras.push_back(to_json(pose_at(scene->camera_path, i, frames)));
  return http::json_response({{"cameras", std::move(cameras)}});
}

}  // namespace raywalk::api
