// Jobs: submit, watch, cancel.
#include <atomic>

#include "server/api/handlers.h"
#include "server/api/wire.h"
#include "server/http/problem.h"

namespace raywalk::api {
namespace {

constexpr std::chrono::seconds kPing{15};
constexpr std::chrono::milliseconds kPatience{500};  // in which a stream sees that the daemon stops
constexpr int kMaxStreams = 200;

/// Counts open streams: each holds a connection's thread.
class StreamPlace {
 public:
  StreamPlace() {
    if (++count() > kMaxStreams) {
      --count();
      throw http::ApiError(503, "busy", "Too many event streams are open.");
    }
  }
  ~StreamPlace() { --count(); }
  StreamPlace(const StreamPlace&) = delete;
  StreamPlace& operator=(const StreamPlace&) = delete;

 private:
  static std::atomic<int>& count() {
    static std::atomic<int> streams{0};
    return streams;
  }
};

std::string event_text(const Job& job) {
  return "id: " + std::to_string(job.version) +
         "\nevent: job\ndata: " + to_json(job).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n\n";
}

}  // namespace

Response list_jobs(Services& s, const Request&) {
  Json jobs = Json::array();
  for (const Job& job : s.jobs.list()) jobs.push_back(to_json(job));
  return http::json_response({{"jobs", jobs}});
}

Response submit_job(Services& s, const Request& r) {
  const auto check = [&](const auto& given) -> JobSpec { return checked(given, s.scenes, s.structures.kinds()); };
  const JobSpec spec = std::visit(check, parse_job_spec(r.json.at("kind"), r.json.at("spec")));
  const JobQueue::Submitted submitted = s.jobs.submit(spec, r.header("idempotency-key"));
  Response response = http::json_response(to_json(submitted.job), submitted.fresh ? 202 : 200);
  response.headers["Location"] = "/v1/jobs/" + submitted.job.id;
  return response;
}

Response get_job(Services& s, const Request& r) {
  return http::json_response(to_json(s.jobs.find(r.path_parameter("job"))));
}

Response cancel_job(Services& s, const Request& r) {
  return http::json_response(to_json(s.jobs.cancel(r.path_parameter("job"))));
}

Response stream_job_events(Services& s, const Request& r) {
  const std::string id = r.path_parameter("job");
  const Job first = s.jobs.find(id);
  // An event is the whole state of the job, so a client that comes back needs the newest one alone.
  const u64 seen = std::strtoull(r.header("last-event-id").c_str(), nullptr, 10);
  struct State {
    StreamPlace place;
    u64 version = 0;
    std::chrono::steady_clock::time_point last_write = std::chrono::steady_clock::now();
  };
  auto state = std::make_shared<State>();
  state->version = first.ended() ? 0 : seen;  // an ended job says so once more
  Response response{200, "text/event-stream", "", {{"Cache-Control", "no-store"}}};
  response.stream = [&jobs = s.jobs, id, state](const http::Write& write) {
    const Job job = jobs.wait_for_change(id, state->version, kPatience);
    const auto now = std::chrono::steady_clock::now();
    if (job.version > state->version) {
      state->version = job.version;
      state->last_write = now;
      return write(event_text(job)) && !job.ended();
    }
    if (now - state->last_write < kPing) return true;
    state->last_write = now;
    return write(": ping\n\n");
  };
  return response;
}

}  // namespace raywalk::api
