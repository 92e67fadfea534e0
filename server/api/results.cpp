// Results of benchmarks, as JSON or CSV.
#include "server/api/accept.h"
#include "server/api/handlers.h"
#include "server/api/wire.h"
#include "server/system/refusal.h"

namespace raywalk::api {

Response get_result(Services& s, const Request& r) {
  const Job job = s.jobs.find(r.path_parameter("job"));
  if (!job.result) {
    if (job.ended()) throw Refusal(Refusal::Why::conflict, "no_result", "The job ended without a result.");
    throw Refusal(Refusal::Why::conflict, "no_result", "The job has not ended yet.").retryable();
  }
  if (negotiate(r.header("accept"), {"application/json", "text/csv"}) == "text/csv") {
    return {200, "text/csv", to_csv(*job.result)};
  }
  return http::json_response(to_json(*job.result, job, s.structures.kinds()));
}

}  // namespace raywalk::api
