// One JSON object an entry point.
#include "server/api/kernel_document.h"

#include <nlohmann/json.hpp>

#include "server/device/cuda/traversal_types.h"

namespace raywalk::api {
namespace {

using Json = nlohmann::ordered_json;

/// "bvh/packet" of "BvhPacket".
std::string wire_name(const std::string& type) {
  for (const cuda::TraversalType& row : cuda::traversal_types()) {
    if (row.type == type) return std::string(row.structure) + '/' + std::string(row.traversal);
  }
  return type;
}

const char* wire_name(Mode mode) {
  switch (mode) {
    case Mode::primary:
      return "primary";
    case Mode::shadow:
      return "shadow";
    case Mode::whitted:
      return "whitted";
  }
  return "";
}

}  // namespace

std::string kernel_document(const std::string& nvrtc_version, const std::vector<cuda::ListedKernel>& kernels) {
  Json rows = Json::array();
  for (const auto& [architecture, spec, report] : kernels) {
    const Json mode = spec.program == cuda::Program::trace ? Json() : Json(wire_name(spec.mode));  // rays have none
    rows.push_back({{"architecture", architecture},
                    {"program", cuda::name_of(spec.program)},
                    {"traversal", wire_name(spec.traversal)},
                    {"intersector", spec.intersector},
                    {"mode", mode},
                    {"features", spec.features},
                    {"block", spec.block},
                    {"registers_cap", spec.registers},
                    {"entry", report.entry},
                    {"registers", report.registers},
                    {"stack_bytes", report.stack_bytes},
                    {"spill_store_bytes", report.spill_store_bytes},
                    {"spill_load_bytes", report.spill_load_bytes},
                    {"shared_bytes", report.shared_bytes}});
  }
  return Json{{"nvrtc", nvrtc_version}, {"kernels", std::move(rows)}}.dump(1);
}

}  // namespace raywalk::api
