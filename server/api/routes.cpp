// The route table.
#include "server/api/handlers.h"

namespace raywalk::api {

std::vector<http::Route> routes(Services& s) {
  const auto to = [&s](Response (*handler)(Services&, const Request&)) {
    return [&s, handler](const Request& request) { return handler(s, request); };
  };
  return {
      {"GET", "/livez", to(get_livez)},
      {"GET", "/readyz", to(get_readyz)},
      {"GET", "/metrics", to(get_metrics)},
      {"GET", "/v1/openapi.json", to(get_openapi)},
      {"GET", "/v1/system", to(get_system)},
      {"GET", "/v1/kinds", to(get_kinds)},
      {"GET", "/v1/scenes", to(list_scenes)},
      {"POST", "/v1/scenes", to(load_scene)},
      {"GET", "/v1/scenes/{scene}", to(get_scene)},
      {"PUT", "/v1/scenes/{scene}", to(upload_scene)},
      {"DELETE", "/v1/scenes/{scene}", to(delete_scene)},
      {"PUT", "/v1/scenes/{scene}/pin", to(pin_scene)},
      {"DELETE", "/v1/scenes/{scene}/pin", to(unpin_scene)},
      {"GET", "/v1/scenes/{scene}/cameras", to(list_cameras)},
      {"GET", "/v1/structures", to(list_structures)},
      {"POST", "/v1/structures", to(build_structure)},
      {"GET", "/v1/structures/{structure}", to(get_structure)},
      {"DELETE", "/v1/structures/{structure}", to(delete_structure)},
      {"PUT", "/v1/structures/{structure}/pin", to(pin_structure)},
      {"DELETE", "/v1/structures/{structure}/pin", to(unpin_structure)},
      {"POST", "/v1/frames", to(render_frame)},
      {"POST", "/v1/rays", to(trace_rays)},
      {"GET", "/v1/jobs", to(list_jobs)},
      {"POST", "/v1/jobs", to(submit_job)},
      {"GET", "/v1/jobs/{job}", to(get_job)},
      {"POST", "/v1/jobs/{job}/cancel", to(cancel_job)},
      {"GET", "/v1/jobs/{job}/events", to(stream_job_events)},
      {"GET", "/v1/results/{job}", to(get_result)},
  };
}

}  // namespace raywalk::api
