// Jobs to rows and back.
#include "server/api/job_store.h"

#include <spdlog/spdlog.h>

#include "server/api/wire.h"
#include "server/http/problem.h"
#include "server/system/time_text.h"

namespace raywalk::api {
namespace {

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

JobState parse_state(const std::string& name) {
  for (const JobState state : {JobState::queued, JobState::running, JobState::validating, JobState::succeeded,
                               JobState::failed, JobState::cancelled, JobState::interrupted}) {
    if (name == state_name(state)) return state;
  }
  throw std::runtime_error("there is no state '" + name + "'");
}

store::JobRow row_of(const Job& job) {
  store::JobRow row;
  row.id = job.id;
  row.kind = kind_name(job.spec);
  row.spec = text_of(to_json(job.spec));
  row.state = state_name(job.state);
  row.stage = job.stage;
  row.key = job.key;
  row.attempt = job.attempt;
  row.version = job.version;
  row.progress = job.progress;
  row.frames_done = job.frames_done;
  row.frames_total = job.frames_total;
  if (job.error) row.error = text_of(error_json(job));
  row.created_at = job.created_at;
  row.started_at = job.started_at;
  row.ended_at = job.ended_at;
  return row;
}

Job job_of(const store::JobRow& row) {
  Job job;
  job.id = row.id;
  job.key = row.key;
  job.spec = parse_job_spec(row.kind, Json::parse(row.spec));
  job.state = parse_state(row.state);
  job.attempt = row.attempt;
  job.progress = row.progress;
  job.stage = row.stage;
  job.frames_done = row.frames_done;
  job.frames_total = row.frames_total;
  if (row.error) job.error = std::make_exception_ptr(KeptProblem{Json::parse(*row.error)});
  job.created_at = row.created_at;
  job.started_at = row.started_at;
  job.ended_at = row.ended_at;
  job.version = row.version;
  job.has_result = row.has_result;
  return job;
}

/// Nothing for a row that another release wrote and this one cannot read.
std::optional<Job> readable(const store::JobRow& row) {
  try {
    return job_of(row);
  } catch (const std::exception& e) {
    spdlog::warn("job {} cannot be read and is forgotten: {}", row.id, e.what());
    return std::nullopt;
  }
}

void end_without_result(Job& job, bool crashed) {
  if (crashed) {
    const std::string detail = "The daemon crashed while the job was at '" + job.stage +
                               "'. It is not run again by itself, for it may be the cause; submit it to try once more.";
    job.error = std::make_exception_ptr(http::ApiError(500, "daemon_crashed", detail));
  }
  job.state = crashed ? JobState::failed : JobState::interrupted;
  job.stage = crashed ? "failed" : "stopped";
  job.ended_at = now_text();
}

template <class Work>
void guarded(const Work& work) {
  try {
    work();
  } catch (const store::DatabaseError& e) {
    throw Refusal(Refusal::Why::unavailable, "storage_failed",
                  std::string("The daemon cannot write to its state folder: ") + e.what() + ".");
  }
}

}  // namespace

std::vector<Job> JobStore::recover() {
  const bool crashed = store_.crashed_before();
  std::vector<Job> jobs;
  for (const store::JobRow& row : store_.jobs()) {
    std::optional<Job> job = readable(row);
    if (!job) {
      forget(row.id);
      continue;
    }
    if (!job->ended()) {
      ++job->version;  // clients that saw it as it was hear of it again
      if (job->state != JobState::queued) {
        end_without_result(*job, crashed);
        spdlog::warn("job {} is {}: the daemon before ended while it ran", job->id, state_name(job->state));
      } else if (crashed) {
        ++job->attempt;
      }
      keep(*job);
    }
    jobs.push_back(std::move(*job));
  }
  return jobs;
}

void JobStore::keep(const Job& job) {
  guarded([&] { store_.save(row_of(job)); });
}

void JobStore::keep(const Job& job, const JobResult& result) {
  const store::ResultRow row = std::visit(
      [&](const auto& one) {
        return store::ResultRow{http::json_response(to_json(one, job, kinds_)).body, to_csv(one)};
      },
      result);
  guarded([&] { store_.save(row_of(job), row); });
}

void JobStore::forget(const std::string& id) {
  guarded([&] { store_.forget_job(id); });
}

}  // namespace raywalk::api
