// Binary rays in, binary hits out.
#include <algorithm>
#include <cstring>
#include <limits>
#include <span>

#include "server/api/handlers.h"
#include "server/api/wire.h"
#include "server/system/refusal.h"

namespace raywalk::api {
namespace {

static_assert(sizeof(Ray) == 32 && sizeof(Hit) == 16, "the wire layout of POST /v1/rays");

/// What an infinite tmax stands for; the kernels take finite rays alone.
constexpr float kUnbounded = std::numeric_limits<float>::max();

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::vector<Ray> parse_rays(const std::string& bytes) {
  if (bytes.size() % sizeof(Ray) != 0) {
    throw Refusal(Refusal::Why::invalid, "bad_rays", "The body is not a whole number of rays of 32 bytes.").at("");
  }
  std::vector<Ray> rays(bytes.size() / sizeof(Ray));
  if (!rays.empty()) std::memcpy(rays.data(), bytes.data(), bytes.size());
  for (Ray& ray : rays) {
    if (ray.tmax == std::numeric_limits<float>::infinity()) ray.tmax = kUnbounded;
  }
  return rays;
}

}  // namespace

Response trace_rays(Services& s, const Request& r) {
  const ScenePtr scene = s.scenes.loaded(r.query.at("scene"), "?scene");
  RayJob job;
  job.structure = s.structures.ready(scene, r.query.at("structure"), "?structure");
  const KindInfo& kind = kind_named(s.structures.kinds(), job.structure->kind(), "?structure");
  const TraversalInfo& traversal = traversal_named(kind, r.query.at("traversal"), "?traversal");
  if (traversal.baseline) {
    throw Refusal(Refusal::Why::invalid, "baseline_only_traces", "A baseline takes no rays; it is for benchmarks.")
        .at("?traversal");
  }
  job.traversal = traversal.name;
  job.kernel = kernel_options(kind, traversal, parse_fixed_tier(r.query.at("tier"), "?tier"), {}, "");
  check_form(job.structure->form(), job.kernel, "?structure");
  const std::vector<Ray> rays = parse_rays(r.bytes);
  job.rays = rays;

  const bool any = r.query.at("query") == "any";
  std::string answer =
      s.queue.run([&](Device& device) { return any ? bytes_of(device.occluded(job)) : bytes_of(device.closest(job)); });
  s.metrics.add_rays(static_cast<double>(rays.size()));
  const auto invalid = std::count_if(rays.begin(), rays.end(), [](const Ray& ray) { return !is_valid(ray); });
  return {200, "application/octet-stream", std::move(answer), {{"X-Invalid-Rays", std::to_string(invalid)}}};
}

}  // namespace raywalk::api
