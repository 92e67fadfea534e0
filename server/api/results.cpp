// Results of jobs, as JSON or CSV: the bytes that were kept when the job ended.
#include "server/api/accept.h"
#include "server/api/handlers.h"
#include "server/system/refusal.h"

namespace raywalk::api {

Response get_result(Services& s, const Request& r) {
  const Job job = s.jobs.find(r.path_parameter("job"));
  const std::optional<store::ResultRow> result = job.has_result ? s.store.result(job.id) : std::nullopt;
  if (!result) {
    if (job.ended()) throw Refusal(Refusal::Why::conflict, "no_result", "The job ended without a result.");
    throw Refusal(Refusal::Why::conflict, "no_result", "The job has not ended yet.").retryable();
  }
  if (negotiate(r.header("accept"), {"application/json", "text/csv"}) == "text/csv") {
    return {200, "text/csv", result->csv};
  }
  return {200, "application/json", result->json};
}

}  // namespace raywalk::api
