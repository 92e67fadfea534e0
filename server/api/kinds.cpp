// Structures and traversals that the device offers.
#include "server/api/handlers.h"
#include "server/api/wire.h"

namespace raywalk::api {

Response get_kinds(Services& s, const Request&) {
  Json kinds = Json::array();
  for (const KindInfo& kind : s.structures.kinds()) kinds.push_back(to_json(kind));
  return http::json_response({{"kinds", kinds}});
}

}  // namespace raywalk::api
