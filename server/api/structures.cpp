// Structures: build, list, evict.
#include "server/api/handlers.h"
#include "server/api/wire.h"

namespace raywalk::api {

Response list_structures(Services& s, const Request&) {
  Json structures = Json::array();
  for (const StructureRecord& record : s.structures.list()) structures.push_back(to_json(record, s.structures.kinds()));
  return http::json_response({{"structures", structures}});
}

Response build_structure(Services& s, const Request& r) {
  const ScenePtr scene = s.scenes.loaded(r.json.at("scene"), "/scene");
  const GivenOptions options = parse_options(r.json.value("options", Json::object()));
  const StructureRecord record = s.structures.build(scene, r.json.at("kind"), options);
  const bool ready = record.state == StructureRecord::State::ready;
  return http::json_response(to_json(record, s.structures.kinds()), ready ? 200 : 202);
}

Response get_structure(Services& s, const Request& r) {
  return http::json_response(to_json(s.structures.find(r.path_parameter("structure")), s.structures.kinds()));
}

Response delete_structure(Services& s, const Request& r) {
  s.structures.evict(r.path_parameter("structure"));
  return http::no_content();
}

}  // namespace raywalk::api
