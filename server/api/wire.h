// Domain values to and from the JSON of the contract.
#pragma once
#include "server/api/services.h"
#include "server/http/message.h"

namespace raywalk::api {

using http::Json;

Json to_json(const SceneEntry& entry);
Json to_json(const StructureRecord& record, const std::vector<KindInfo>& kinds);
Json to_json(const CameraPose& pose);
Json to_json(const KindInfo& kind);
Json to_json(const Machine& machine);
Json to_json(const BenchmarkSpec& spec);
Json to_json(const Job& job);
Json to_json(const BenchmarkResult& result, const Job& job, const std::vector<KindInfo>& kinds);
/// One line a row, with a header line.
std::string to_csv(const BenchmarkResult& result);

const char* mode_name(BenchMode mode);

GivenOptions parse_options(const Json& json);
BenchmarkSpec parse_spec(const Json& json);
Mode parse_mode(const Json& json);
Output parse_output(const Json& json);
/// `json` is a CameraPose or a PathFrame; null is the first frame. Throws Refusal invalid_camera.
CameraPose parse_camera(const Json& json, const LoadedScene& scene);

}  // namespace raywalk::api
