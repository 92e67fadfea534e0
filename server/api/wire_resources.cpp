// JSON of scenes, structures, kinds, cameras and the machine.
#include <cmath>

#include "server/api/wire.h"
#include "server/device/camera.h"
#include "server/system/refusal.h"

namespace raywalk::api {
namespace {

Json to_json(Vec3 v) {
  return Json::array({v.x, v.y, v.z});
}

Vec3 parse_vec3(const Json& json) {
  return {static_cast<float>(json[0].get<double>()), static_cast<float>(json[1].get<double>()),
          static_cast<float>(json[2].get<double>())};
}

Json option_json(const GivenOption& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  const double number = std::get<double>(value);
  if (std::floor(number) == number && std::abs(number) < 1e15) return static_cast<std::int64_t>(number);
  return number;
}

Json to_json(const Option& option) {
  Json json = {{"name", option.name}, {"help", option.help}};
  json["default"] = option_json(shown_option(option, option.default_value));
  if (!option.choices.empty()) {
    json["choices"] = option.choices;
    return json;
  }
  json["minimum"] = option.min;
  json["maximum"] = option.max;
  json["integer"] = option.integer;
  if (option.step > 0) json["step"] = option_json(option.step);
  return json;
}

std::string state_name(StructureRecord::State state) {
  return state == StructureRecord::State::ready    ? "ready"
         : state == StructureRecord::State::failed ? "failed"
                                                   : "building";
}

}  // namespace

Json options_json(const std::vector<Option>& options, const OptionValues& values) {
  Json json = Json::object();
  for (const Option& option : options) {
    json[std::string(option.name)] = option_json(shown_option(option, values.find(option.name)->second));
  }
  return json;
}

Json to_json(const SceneEntry& entry) {
  const SceneInfo& info = entry.info;
  const LoadedScene* loaded = entry.loaded.get();
  std::string source = info.source;
  const bool is_theirs = info.fidelity == Fidelity::kOriginal || info.fidelity == Fidelity::kDerived;
  if (is_theirs && !info.credit.empty()) source += (source.empty() ? "" : "; ") + info.credit;
  Json json = {{"name", info.name},
               {"title", info.title},
               {"description", info.prose},
               {"triangles", info.triangles},
               {"lights", info.lights},
               {"fidelity", loaded != nullptr && loaded->uploaded ? "uploaded" : fidelity_name(info.fidelity)},
               {"fidelity_note", info.fidelity_note},
               {"available", info.available},
               {"source", source},
               {"loaded", loaded != nullptr},
               {"size_bytes", loaded != nullptr ? loaded->blob->size_bytes() : 0},
               {"hash", loaded != nullptr ? loaded->content_sha256 : ""},
               {"frames", info.frames},
               {"warnings", loaded != nullptr ? loaded->warnings : std::vector<std::string>{}}};
  if (!info.paper_json.empty()) json["paper"] = Json::parse(info.paper_json);
  if (loaded != nullptr) {
    json["load_ms"] = loaded->load_ms;
    json["cameras"] = Json::array();
    for (const NamedCamera& camera : loaded->cameras) {
      json["cameras"].push_back({{"name", camera.name}, {"pose", to_json(camera.pose)}});
    }
    if (!loaded->bounds.empty()) {
      json["bounds"] = {{"lo", to_json(loaded->bounds.lo)}, {"hi", to_json(loaded->bounds.hi)}};
    }
  }
  return json;
}

namespace {

/// The figures of a build that found too little device memory.
void add_shortage(const std::exception_ptr& device_error, Json& json) {
  try {
    std::rethrow_exception(device_error);
  } catch (const OutOfDeviceMemory& e) {
    if (e.needed_bytes() > 0) json["needed_bytes"] = e.needed_bytes();  // 0: not known
    json["free_bytes"] = e.free_bytes();
  } catch (const DeviceLost&) {  // its text says it all
  }
}

}  // namespace

Json to_json(const StructureRecord& record, const std::vector<KindInfo>& kinds) {
  Json json = {{"id", record.id},
               {"scene", record.scene},
               {"kind", record.kind},
               {"options", options_json(kind_named(kinds, record.kind, "").options, record.options)},
               {"state", state_name(record.state)}};
  if (!record.error.empty()) json["error"] = record.error;
  if (record.device_error) add_shortage(record.device_error, json);
  if (!record.structure) return json;
  const BuildStats& stats = record.structure->stats();
  json["nodes"] = stats.nodes;
  json["leaves"] = stats.leaves;
  json["references"] = stats.references;
  json["references_per_triangle"] =
      record.triangles == 0 ? 0.0 : static_cast<double>(stats.references) / static_cast<double>(record.triangles);
  json["size_bytes"] = stats.size_bytes;
  json["max_depth"] = stats.max_depth;
  if (stats.resolution[0] > 0) json["resolution"] = {stats.resolution[0], stats.resolution[1], stats.resolution[2]};
  if (std::isfinite(stats.sah_cost)) json["sah_cost"] = stats.sah_cost;
  json["build_ms"] = stats.build_ms;
  return json;
}

Json to_json(const KindInfo& kind) {
  Json options = Json::array(), traversals = Json::array();
  for (const Option& option : kind.options) options.push_back(to_json(option));
  for (const TraversalInfo& t : kind.traversals) {
    Json of_kernel = Json::array();
    for (const Option& option : t.options) of_kernel.push_back(to_json(option));
    traversals.push_back({{"name", t.name}, {"help", t.help}, {"baseline", t.baseline}, {"options", of_kernel}});
  }
  return {{"name", kind.name}, {"help", kind.help}, {"options", options}, {"traversals", traversals}};
}

Json to_json(const CameraPose& pose) {
  return {{"eye", to_json(pose.eye)},
          {"target", to_json(pose.target)},
          {"up", to_json(pose.up)},
          {"vertical_fov_deg", pose.vertical_fov_deg}};
}

Json to_json(const Machine& m) {
  return {{"fingerprint", m.fingerprint},
          {"hostname", m.hostname},
          {"os", m.os},
          {"kernel", m.kernel},
          {"cpu", m.cpu},
          {"cores", m.cores},
          {"threads", m.threads},
          {"memory_bytes", m.memory_bytes},
          {"governor", m.governor},
          {"device", m.device},
          {"device_details", m.device_details},
          {"compiler", m.compiler},
          {"build_type", m.build_type},
          {"build_flags", m.build_flags},
          {"version", m.version},
          {"git_commit", m.git_commit},
          {"libraries", m.libraries}};
}

Json to_json(const GivenOptions& options) {
  Json json = Json::object();
  for (const auto& [name, value] : options) json[name] = option_json(value);
  return json;
}

GivenOptions parse_options(const Json& json) {
  GivenOptions options;
  for (const auto& [name, value] : json.items()) {
    if (value.is_string()) {
      options[name] = value.get<std::string>();
    } else {
      options[name] = value.get<double>();
    }
  }
  return options;
}

Mode parse_mode(const Json& json) {
  const std::string name = json.is_null() ? "primary" : json.get<std::string>();
  return name == "whitted" ? Mode::whitted : name == "shadow" ? Mode::shadow : Mode::primary;
}

Output parse_output(const Json& json) {
  const std::string name = json.get<std::string>();
  return name == "depth"    ? Output::depth
         : name == "normal" ? Output::normal
         : name == "id"     ? Output::id
         : name == "steps"  ? Output::steps
                            : Output::color;
}

CameraPose parse_camera(const Json& json, const LoadedScene& scene) {
  if (json.is_null()) return pose_at(scene.camera_path, 0, 1);
  if (json.contains("frame")) {
    const u32 frame = json.at("frame").get<u32>(), of = json.at("of").get<u32>();
    if (frame >= of) {
      throw Refusal(Refusal::Why::invalid, "invalid_camera", "The frame is not below the number of frames.")
          .at("/camera/frame");
    }
    return pose_at(scene.camera_path, frame, of);
  }
  CameraPose pose;
  pose.eye = parse_vec3(json.at("eye"));
  pose.target = parse_vec3(json.at("target"));
  if (json.contains("up")) pose.up = parse_vec3(json.at("up"));
  pose.vertical_fov_deg = json.at("vertical_fov_deg").get<float>();
  try {
    camera_of(pose, 1, 1);
  } catch (const std::invalid_argument& e) {
    throw Refusal(Refusal::Why::invalid, "invalid_camera", e.what()).at("/camera");
  }
  return pose;
}

}  // namespace raywalk::api
