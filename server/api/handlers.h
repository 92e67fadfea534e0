// The handlers of all resources; one file each.
#pragma once
#include "server/api/services.h"

namespace raywalk::api {

using http::Request;
using http::Response;

Response get_livez(Services&, const Request&);
Response get_readyz(Services&, const Request&);
Response get_metrics(Services&, const Request&);
Response get_openapi(Services&, const Request&);
Response get_system(Services&, const Request&);
Response get_kinds(Services&, const Request&);

Response list_scenes(Services&, const Request&);
Response load_scene(Services&, const Request&);
Response get_scene(Services&, const Request&);
Response upload_scene(Services&, const Request&);
Response delete_scene(Services&, const Request&);
Response pin_scene(Services&, const Request&);
Response unpin_scene(Services&, const Request&);
Response list_cameras(Services&, const Request&);

Response list_structures(Services&, const Request&);
Response build_structure(Services&, const Request&);
Response get_structure(Services&, const Request&);
Response delete_structure(Services&, const Request&);
Response pin_structure(Services&, const Request&);
Response unpin_structure(Services&, const Request&);

Response render_frame(Services&, const Request&);
Response trace_rays(Services&, const Request&);

Response list_jobs(Services&, const Request&);
Response submit_job(Services&, const Request&);
Response get_job(Services&, const Request&);
Response cancel_job(Services&, const Request&);
Response stream_job_events(Services&, const Request&);
Response get_result(Services&, const Request&);

}  // namespace raywalk::api
