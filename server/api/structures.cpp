// Structures: build, list, evict, pin.
#include "server/api/handlers.h"
#include "server/api/wire.h"

namespace raywalk::api {
namespace {

Json structure_json(Services& s, const StructureRecord& record) {
  Json json = to_json(record, s.structures.kinds());
  json["pinned"] = s.pins.has(record.id);
  return json;
}

}  // namespace

Response list_structures(Services& s, const Request&) {
  Json structures = Json::array();
  for (const StructureRecord& record : s.structures.list()) structures.push_back(structure_json(s, record));
  return http::json_response({{"structures", structures}});
}

Response build_structure(Services& s, const Request& r) {
  const ScenePtr scene = s.scenes.loaded(r.json.at("scene"), "/scene");
  const GivenOptions options = parse_options(r.json.value("options", Json::object()));
  const StructureRecord record = s.structures.build(scene, r.json.at("kind"), options);
  const bool ready = record.state == StructureRecord::State::ready;
  return http::json_response(structure_json(s, record), ready ? 200 : 202);
}

Response get_structure(Services& s, const Request& r) {
  return http::json_response(structure_json(s, s.structures.find(r.path_parameter("structure"))));
}

Response delete_structure(Services& s, const Request& r) {
  s.pins.refuse(r.path_parameter("structure"));
  s.structures.evict(r.path_parameter("structure"));
  return http::no_content();
}

Response pin_structure(Services& s, const Request& r) {
  s.pins.add(s.structures.find(r.path_parameter("structure")).id);
  return http::no_content();
}

Response unpin_structure(Services& s, const Request& r) {
  s.pins.remove(s.structures.find(r.path_parameter("structure")).id);
  return http::no_content();
}

}  // namespace raywalk::api
