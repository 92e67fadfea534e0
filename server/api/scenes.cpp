// Scenes: list, load, upload, evict, cameras.
#include "server/api/handlers.h"
#include "server/api/wire.h"

namespace raywalk::api {
namespace {

Json scene_json(const ScenePtr& scene) {
  return to_json(SceneEntry{scene->info, scene});
}

}  // namespace

Response list_scenes(Services& s, const Request&) {
  Json scenes = Json::array();
  for (const SceneEntry& entry : s.scenes.list()) scenes.push_back(to_json(entry));
  return http::json_response({{"scenes", scenes}});
}

Response load_scene(Services& s, const Request& r) {
  std::optional<u64> triangles;
  if (r.json.contains("triangles")) triangles = r.json.at("triangles").get<u64>();
  const Scenes::Loading loading = s.scenes.load(r.json.at("name"), triangles);
  return http::json_response(scene_json(loading.scene), loading.fresh ? 201 : 200);
}

Response get_scene(Services& s, const Request& r) {
  return http::json_response(to_json(s.scenes.find(r.path_parameter("scene"))));
}

Response upload_scene(Services& s, const Request& r) {
  const std::string extension = r.query.contains("extension") ? "." + r.query.at("extension").get<std::string>() : "";
  return http::json_response(scene_json(s.scenes.upload(r.path_parameter("scene"), r.file, extension)), 201);
}

Response delete_scene(Services& s, const Request& r) {
  s.scenes.evict(r.path_parameter("scene"));
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
