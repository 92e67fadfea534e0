// JSON of jobs and of what benchmarks are asked for.
#include "server/api/wire.h"
#include "server/http/problem.h"
#include "server/system/refusal.h"

namespace raywalk::api {
namespace {

BenchMode parse_bench_mode(const std::string& name) {
  return name == "trace"     ? BenchMode::trace
         : name == "shadow"  ? BenchMode::shadow
         : name == "whitted" ? BenchMode::whitted
                             : BenchMode::primary;
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

}  // namespace

const char* state_name(JobState state) {
  switch (state) {
    case JobState::queued:
      return "queued";
    case JobState::running:
      return "running";
    case JobState::validating:
      return "validating";
    case JobState::succeeded:
      return "succeeded";
    case JobState::failed:
      return "failed";
    case JobState::cancelled:
      return "cancelled";
    case JobState::interrupted:
      return "interrupted";
  }
  return "failed";
}

Json error_json(const Job& job) {
  if (!job.error) return nullptr;
  try {
    std::rethrow_exception(job.error);
  } catch (const KeptProblem& kept) {
    return kept.json;
  } catch (...) {
    http::Problem problem = http::problem_of_current_exception(job.id);
    return http::to_json(problem, "/v1/jobs/" + job.id, job.id);
  }
}

BenchmarkSpec parse_spec(const Json& json) {
  BenchmarkSpec spec;
  spec.scene = json.at("scene");
  for (const Json& t : json.value("techniques", Json::array())) {
    spec.techniques.push_back({t.at("structure"), t.at("traversal"), parse_options(t.value("options", Json::object())),
                               parse_options(t.value("kernel", Json::object())),
                               parse_tier(t.value("tier", "strict"))});
  }
  for (const Json& mode : json.at("modes")) spec.modes.push_back(parse_bench_mode(mode));
  spec.depth = json.at("depth");
  spec.width = json.at("width");
  spec.height = json.at("height");
  spec.frames = json.at("frames");
  spec.warmup = json.at("warmup");
  spec.repeats = json.at("repeats");
  spec.batch = json.at("batch");
  spec.error_frames = json.at("error_frames");
  spec.time_limit_s = json.at("time_limit_s");
  return spec;
}

Tier parse_tier(const std::string& text) {
  return text == "fast" ? Tier::fast : text == "auto" ? Tier::automatic : Tier::strict;
}

Tier parse_fixed_tier(const std::string& text, const std::string& pointer) {
  const Tier tier = parse_tier(text);
  if (tier == Tier::automatic) {
    throw Refusal(Refusal::Why::invalid, "tier_needs_benchmark",
                  "Tier auto is a choice that a benchmark measures; here it is strict or fast.")
        .at(pointer);
  }
  return tier;
}

Json to_json(const BenchmarkSpec& spec) {
  Json techniques = Json::array(), modes = Json::array();
  for (const TechniqueSpec& t : spec.techniques) {
    Json technique = {{"structure", t.structure}, {"traversal", t.traversal}};
    if (!t.options.empty()) technique["options"] = to_json(t.options);
    if (!t.kernel.empty()) technique["kernel"] = to_json(t.kernel);
    technique["tier"] = tier_name(t.tier);
    techniques.push_back(std::move(technique));
  }
  for (const BenchMode mode : spec.modes) modes.push_back(mode_name(mode));
  return {{"scene", spec.scene},
          {"techniques", techniques},
          {"modes", modes},
          {"depth", spec.depth},
          {"width", spec.width},
          {"height", spec.height},
          {"frames", spec.frames},
          {"warmup", spec.warmup},
          {"repeats", spec.repeats},
          {"batch", spec.batch},
          {"error_frames", spec.error_frames},
          {"time_limit_s", spec.time_limit_s}};
}

const char* kind_name(const JobSpec& spec) {
  return std::holds_alternative<BenchmarkSpec>(spec) ? "benchmark" : "accuracy";
}

Json to_json(const JobSpec& spec) {
  return std::visit([](const auto& one) { return to_json(one); }, spec);
}

JobSpec parse_job_spec(const std::string& kind, const Json& json) {
  if (kind == "accuracy") return parse_accuracy_spec(json);
  return parse_spec(json);
}

Json to_json(const Job& job) {
  return {{"id", job.id},
          {"kind", kind_name(job.spec)},
          {"spec", to_json(job.spec)},
          {"state", state_name(job.state)},
          {"position", job.position},
          {"progress", job.progress},
          {"stage", job.stage},
          {"frames_done", job.frames_done},
          {"frames_total", job.frames_total},
          {"eta_s", value_or_null(job.eta_s)},
          {"attempt", job.attempt},
          {"result", job.has_result ? Json(job.id) : Json(nullptr)},
          {"error", error_json(job)},
          {"created_at", job.created_at},
          {"started_at", text_or_null(job.started_at)},
          {"ended_at", text_or_null(job.ended_at)}};
}

}  // namespace raywalk::api
