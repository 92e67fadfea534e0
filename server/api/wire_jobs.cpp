// JSON of benchmarks: specs, jobs and results.
#include <cmath>
#include <sstream>

#include "server/api/wire.h"
#include "server/http/problem.h"

namespace raywalk::api {
namespace {

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

BenchMode parse_bench_mode(const std::string& name) {
  return name == "trace"     ? BenchMode::trace
         : name == "shadow"  ? BenchMode::shadow
         : name == "whitted" ? BenchMode::whitted
                             : BenchMode::primary;
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

template <class T>
Json value_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json error_json(const Job& job) {
  if (!job.error) return nullptr;
  try {
    std::rethrow_exception(job.error);
  } catch (...) {
    http::Problem problem = http::problem_of_current_exception(job.id);
    return http::to_json(problem, "/v1/jobs/" + job.id, job.id);
  }
}

Json to_json(const Statistics& s) {
  return {
      {"median", s.median},   {"mean", s.mean}, {"sd", s.sd},   {"mad", s.mad},           {"min", s.min},
      {"p5", s.p5},           {"p95", s.p95},   {"p99", s.p99}, {"ci95_low", s.ci95_low}, {"ci95_high", s.ci95_high},
      {"samples", s.samples}, {"discarded", 0}, {"failed", 0},  {"unstable", s.unstable}};
}

Json to_json(const ErrorFigures& e) {
  const double rmse = e.image_rmse();
  return {{"reference", e.reference},
          {"frames", e.frames},
          {"pixels", e.pixels},
          {"id_mismatches", e.id_mismatches},
          {"id_mismatch_ppm", e.mismatch_ppm()},
          {"id_mismatch_ppm_upper95", e.mismatch_ppm_upper95()},
          {"ties", e.ties},
          {"image_rmse", rmse},
          {"image_psnr_db", rmse > 0 ? Json(-20.0 * std::log10(rmse)) : Json(nullptr)}};
}

Json to_json(const ResultRow& row) {
  return {{"structure", row.structure},
          {"traversal", row.traversal},
          {"structure_id", row.structure_id},
          {"mode", mode_name(row.mode)},
          {"frame_ms", to_json(row.frame_ms)},
          {"mrays_per_s", row.mrays_per_s},
          {"rays_per_frame", row.rays_per_frame},
          {"steps_per_ray", value_or_null(row.steps_per_ray)},
          {"tests_per_ray", value_or_null(row.tests_per_ray)},
          {"frame_times_ms", row.frame_times_ms},
          {"error", to_json(row.error)}};
}

}  // namespace

const char* mode_name(BenchMode mode) {
  switch (mode) {
    case BenchMode::trace:
      return "trace";
    case BenchMode::primary:
      return "primary";
    case BenchMode::shadow:
      return "shadow";
    case BenchMode::whitted:
      return "whitted";
  }
  return "primary";
}

BenchmarkSpec parse_spec(const Json& json) {
  BenchmarkSpec spec;
  spec.scene = json.at("scene");
  for (const Json& t : json.value("techniques", Json::array())) {
    spec.techniques.push_back(
        {t.at("structure"), t.at("traversal"), parse_options(t.value("options", Json::object()))});
  }
  for (const Json& mode : json.at("modes")) spec.modes.push_back(parse_bench_mode(mode));
  spec.depth = json.at("depth");
  spec.width = json.at("width");
  spec.height = json.at("height");
  spec.frames = json.at("frames");
  spec.warmup = json.at("warmup");
  spec.repeats = json.at("repeats");
  spec.error_frames = json.at("error_frames");
  spec.time_limit_s = json.at("time_limit_s");
  return spec;
}

Json to_json(const BenchmarkSpec& spec) {
  Json techniques = Json::array(), modes = Json::array();
  for (const TechniqueSpec& t : spec.techniques) {
    Json technique = {{"structure", t.structure}, {"traversal", t.traversal}};
    for (const auto& [name, value] : t.options) {
      std::visit([&, &key = name](const auto& v) { technique["options"][key] = v; }, value);
    }
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
          {"error_frames", spec.error_frames},
          {"time_limit_s", spec.time_limit_s}};
}

Json to_json(const Job& job) {
  return {{"id", job.id},
          {"kind", "benchmark"},
          {"spec", to_json(job.spec)},
          {"state", state_name(job.state)},
          {"position", job.position},
          {"progress", job.progress},
          {"stage", job.stage},
          {"frames_done", job.frames_done},
          {"frames_total", job.frames_total},
          {"eta_s", value_or_null(job.eta_s)},
          {"attempt", 1},
          {"result", job.result ? Json(job.id) : Json(nullptr)},
          {"error", error_json(job)},
          {"created_at", job.created_at},
          {"started_at", text_or_null(job.started_at)},
          {"ended_at", text_or_null(job.ended_at)}};
}

Json to_json(const BenchmarkResult& result, const Job& job, const std::vector<KindInfo>& kinds) {
  Json structures = Json::array(), rows = Json::array();
  for (const StructureRecord& record : result.structures) structures.push_back(to_json(record, kinds));
  for (const ResultRow& row : result.rows) rows.push_back(to_json(row));
  return {{"schema_version", 1},
          {"id", job.id},
          {"created_at", result.created_at},
          {"machine", to_json(result.machine)},
          {"scene", to_json(SceneEntry{result.scene->info, result.scene})},
          {"spec", to_json(job.spec)},
          {"structures", structures},
          {"rows", rows},
          {"stop_reason", result.reached_time_limit ? "time_limit" : "completed"},
          {"notes", result.notes}};
}

std::string to_csv(const BenchmarkResult& result) {
  std::ostringstream out;
  out << "scene,structure,traversal,structure_id,mode,median_ms,mean_ms,sd_ms,min_ms,p95_ms,ci95_low_ms,ci95_high_ms,"
         "samples,unstable,mrays_per_s,rays_per_frame,steps_per_ray,tests_per_ray,reference,id_mismatch_ppm,ties,"
         "image_rmse\n";
  out.precision(9);
  const auto number = [](const std::optional<double>& v) { return v ? Json(*v).dump() : std::string(); };
  for (const ResultRow& row : result.rows) {
    const Statistics& s = row.frame_ms;
    out << result.scene->info.name << ',' << row.structure << ',' << row.traversal << ',' << row.structure_id << ','
        << mode_name(row.mode) << ',' << s.median << ',' << s.mean << ',' << s.sd << ',' << s.min << ',' << s.p95 << ','
        << s.ci95_low << ',' << s.ci95_high << ',' << s.samples << ',' << (s.unstable ? "true" : "false") << ','
        << row.mrays_per_s << ',' << row.rays_per_frame << ',' << number(row.steps_per_ray) << ','
        << number(row.tests_per_ray) << ',' << row.error.reference << ',' << row.error.mismatch_ppm() << ','
        << row.error.ties << ',' << row.error.image_rmse() << '\n';
  }
  return out.str();
}

}  // namespace raywalk::api
