// The machine, the contract, health and metrics.
#include "server/api/handlers.h"
#include "server/api/wire.h"

namespace raywalk::api {
namespace {

Json device_json(Services& s) {
  const DeviceInfo& info = s.queue.device().info();
  const DeviceMemory memory = s.queue.device().memory();
  return {{"name", info.name},
          {"kind", info.kind},
          {"requested", s.requested_device},
          {"no_cuda", s.no_cuda.empty() ? Json(nullptr) : Json(s.no_cuda)},
          {"details", info.details},
          {"memory",
           {{"total_bytes", memory.total_bytes},
            {"free_bytes", memory.free_bytes},
            {"resident_bytes", memory.resident_bytes}}}};
}

}  // namespace

Response get_livez(Services&, const Request&) {
  return {200, "text/plain", "alive\n"};
}

Response get_readyz(Services& s, const Request&) {
  if (const std::optional<std::string> cause = s.queue.lost()) throw DeviceLost(*cause);
  return {200, "text/plain", "ready\n"};
}

Response get_metrics(Services& s, const Request&) {
  Metrics::Gauges gauges;
  gauges.queue_depth = static_cast<double>(s.queue.depth());
  gauges.jobs_queued = static_cast<double>(s.jobs.queued());
  gauges.scenes = static_cast<double>(s.scenes.resident_count());
  gauges.structures = static_cast<double>(s.structures.resident_count());
  gauges.resident_bytes = static_cast<double>(s.scenes.resident_bytes() + s.structures.resident_bytes());
  gauges.device_memory = s.queue.device().memory();
  return {200, "text/plain; version=0.0.4", s.metrics.text(gauges)};
}

Response get_openapi(Services& s, const Request&) {
  return {200, "application/json", s.contract.text()};
}

Response get_system(Services& s, const Request&) {
  const std::chrono::duration<double> uptime = std::chrono::steady_clock::now() - s.started;
  return http::json_response({{"machine", to_json(s.machine)},
                              {"device", device_json(s)},
                              {"limits",
                               {{"json_bytes", s.limits.json_bytes},
                                {"upload_bytes", s.limits.upload_bytes},
                                {"rays_bytes", s.limits.rays_bytes},
                                {"pixels", u64{kMaxSidePixels} * kMaxSidePixels},
                                {"side_pixels", kMaxSidePixels},
                                {"depth", kMaxDepth},
                                {"frames", kMaxFrames},
                                {"triangles", kMaxTriangles},
                                {"queued_jobs", JobQueue::kMaxQueued}}},
                              {"resident",
                               {{"scenes", s.scenes.resident_count()},
                                {"structures", s.structures.resident_count()},
                                {"bytes", s.scenes.resident_bytes() + s.structures.resident_bytes()}}},
                              {"uptime_s", uptime.count()},
                              {"warnings", s.warnings}});
}

}  // namespace raywalk::api
