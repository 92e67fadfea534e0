// One frame: from a request to an image, in one straight line.
#include <cstdio>

#include "server/api/accept.h"
#include "server/api/handlers.h"
#include "server/api/wire.h"
#include "server/http/problem.h"
#include "server/image/encode.h"
#include "server/system/refusal.h"

namespace raywalk::api {
namespace {

constexpr u64 kLargeFramePixels = u64{4096} * 4096;

struct Encoding {
  std::string media_type;
  ImageFormat format;
};

Encoding encoding_for(const std::string& accept) {
  static const std::vector<Encoding> offered = {{"image/jpeg", ImageFormat::jpeg},
                                                {"image/png", ImageFormat::png},
                                                {"image/x-exr", ImageFormat::exr},
                                                {"application/octet-stream", ImageFormat::raw}};
  std::vector<std::string> types;
  for (const Encoding& encoding : offered) types.push_back(encoding.media_type);
  const std::optional<std::string> chosen = negotiate(accept, types);
  for (const Encoding& encoding : offered) {
    if (chosen == encoding.media_type) return encoding;
  }
  throw http::ApiError(406, "not_acceptable",
                       "A frame is image/jpeg, image/png, image/x-exr or application/octet-stream.");
}

FrameJob make_job(Services& s, const Json& q) {
  const ScenePtr scene = s.scenes.loaded(q.at("scene"), "/scene");
  FrameJob job;
  job.structure = s.structures.ready(scene, q.at("structure"), "/structure");
  const KindInfo& kind = kind_named(s.structures.kinds(), job.structure->kind(), "/structure");
  const TraversalInfo& traversal = traversal_named(kind, q.at("traversal"), "/traversal");
  if (traversal.baseline) {
    throw Refusal(Refusal::Why::invalid, "baseline_only_traces", "A baseline shades no frames; it is for benchmarks.")
        .at("/traversal");
  }
  job.traversal = traversal.name;
  job.kernel = kernel_options(kind, traversal, parse_fixed_tier(q.value("tier", "strict"), "/tier"),
                              parse_options(q.value("kernel", Json::object())), "/kernel");
  check_form(job.structure->form(), job.kernel, "/kernel/intersector");
  job.camera = parse_camera(q.value("camera", Json()), *scene);
  job.width = q.at("width");
  job.height = q.at("height");
  job.mode = parse_mode(q.value("mode", Json()));
  job.depth = q.at("depth");
  job.lights = q.value("lights", kAllLights);
  job.output = parse_output(q.at("output"));
  return job;
}

std::string timing_header(double queue_ms, const Frame& frame, double encode_ms) {
  char text[160];
  std::snprintf(text, sizeof text, "queue;dur=%.3f, trace;dur=%.3f, readback;dur=%.3f, encode;dur=%.3f", queue_ms,
                frame.trace_ms, frame.readback_ms, encode_ms);
  return text;
}

}  // namespace

Response render_frame(Services& s, const Request& r) {
  const Encoding encoding = encoding_for(r.header("accept"));
  const FrameJob job = make_job(s, r.json);
  std::unique_lock<std::mutex> one_at_a_time;
  if (u64{job.width} * job.height > kLargeFramePixels) one_at_a_time = std::unique_lock(s.large_frame);

  FramePool::Lease lease = s.frames.lease();
  Frame& frame = lease.frame();
  double queue_ms = 0;
  s.queue.run([&](Device& device) { device.render(job, frame); }, &queue_ms);
  s.metrics.add_frame(frame.trace_ms);

  const auto begin = std::chrono::steady_clock::now();
  std::string bytes = encode(frame, job.output, encoding.format);
  const std::chrono::duration<double, std::milli> encode_ms = std::chrono::steady_clock::now() - begin;
  return {200,
          encoding.media_type,
          std::move(bytes),
          {{"Server-Timing", timing_header(queue_ms, frame, encode_ms.count())}, {"Cache-Control", "no-store"}}};
}

}  // namespace raywalk::api
