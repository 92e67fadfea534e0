// Domain values to and from the JSON of the contract.
#pragma once
#include <optional>

#include "server/api/services.h"
#include "server/http/message.h"

namespace raywalk::api {

using http::Json;

template <class T>
Json value_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json to_json(const SceneEntry& entry);
Json to_json(const StructureRecord& record, const std::vector<KindInfo>& kinds);
Json to_json(const CameraPose& pose);
Json to_json(const KindInfo& kind);
/// Complete `values` of `options`, as a request would give them.
Json options_json(const std::vector<Option>& options, const OptionValues& values);
Json to_json(const Machine& machine);
Json to_json(const BenchmarkSpec& spec);
Json to_json(const accuracy::AccuracySpec& spec);
Json to_json(const JobSpec& spec);
Json to_json(const Job& job);
Json to_json(const Statistics& statistics);
Json to_json(const BenchmarkResult& result, const Job& job, const std::vector<KindInfo>& kinds);
Json to_json(const accuracy::AccuracyResult& result, const Job& job, const std::vector<KindInfo>& kinds);
/// One line a row, with a header line.
std::string to_csv(const BenchmarkResult& result);
/// Of the sweep, or of the hard cases when there is no scene.
std::string to_csv(const accuracy::AccuracyResult& result);

/// The problem of a job that failed in an earlier daemon, as it was told then.
struct KeptProblem {
  Json json;
};
/// The problem that a job failed with; null for others.
Json error_json(const Job& job);

const char* state_name(JobState state);

Json to_json(const GivenOptions& options);
GivenOptions parse_options(const Json& json);
/// `text` is one that the contract has.
Tier parse_tier(const std::string& text);
/// For what is not a benchmark. Throws Refusal tier_needs_benchmark for tier auto.
Tier parse_fixed_tier(const std::string& text, const std::string& pointer);
BenchmarkSpec parse_spec(const Json& json);
accuracy::AccuracySpec parse_accuracy_spec(const Json& json);
/// "benchmark" or "accuracy".
const char* kind_name(const JobSpec& spec);
JobSpec parse_job_spec(const std::string& kind, const Json& json);
Mode parse_mode(const Json& json);
Output parse_output(const Json& json);
/// `json` is a CameraPose or a PathFrame; null is the first frame. Throws Refusal invalid_camera.
CameraPose parse_camera(const Json& json, const LoadedScene& scene);

}  // namespace raywalk::api
