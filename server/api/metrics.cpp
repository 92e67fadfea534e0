// Counters, histograms and gauges.
#include "server/api/metrics.h"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

namespace raywalk::api {
namespace {

const prometheus::Histogram::BucketBoundaries kSeconds{0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1,
                                                       0.2,   0.5,   1,     2,    5,    10,   30};

}  // namespace

struct Metrics::Impl {
  prometheus::Registry registry;
  prometheus::Family<prometheus::Counter>& requests = prometheus::BuildCounter()
                                                          .Name("raywalk_requests_total")
                                                          .Help("Requests by route and status.")
                                                          .Register(registry);
  prometheus::Family<prometheus::Histogram>& latency = prometheus::BuildHistogram()
                                                           .Name("raywalk_request_seconds")
                                                           .Help("Time from the request's headers to its answer.")
                                                           .Register(registry);
  prometheus::Family<prometheus::Gauge>& resident =
      prometheus::BuildGauge().Name("raywalk_resident").Help("What is resident, by what it is.").Register(registry);

  prometheus::Counter& frames = counter("raywalk_frames_total", "Frames rendered for requests.");
  prometheus::Counter& rays = counter("raywalk_rays_total", "Rays traced for requests of /v1/rays.");
  prometheus::Histogram& trace = prometheus::BuildHistogram()
                                     .Name("raywalk_frame_trace_seconds")
                                     .Help("Traversal and shading of one frame.")
                                     .Register(registry)
                                     .Add({}, kSeconds);
  prometheus::Gauge& queue_depth = gauge("raywalk_device_queue_depth", "Tasks that wait for the device.");
  prometheus::Gauge& jobs_queued = gauge("raywalk_jobs_queued", "Benchmark jobs that wait.");
  prometheus::Gauge& resident_bytes = gauge("raywalk_resident_bytes", "Bytes of resident scenes and structures.");
  prometheus::Gauge& scenes = resident.Add({{"what", "scenes"}});
  prometheus::Gauge& structures = resident.Add({{"what", "structures"}});

  prometheus::Family<prometheus::Gauge>& device_memory = prometheus::BuildGauge()
                                                             .Name("raywalk_device_memory_bytes")
                                                             .Help("Memory of the device itself; 0 for a CPU.")
                                                             .Register(registry);
  prometheus::Gauge& device_total = device_memory.Add({{"what", "total"}});
  prometheus::Gauge& device_free = device_memory.Add({{"what", "free"}});
  prometheus::Gauge& device_resident = device_memory.Add({{"what", "resident"}});

  prometheus::Counter& counter(const char* name, const char* help) {
    return prometheus::BuildCounter().Name(name).Help(help).Register(registry).Add({});
  }
  prometheus::Gauge& gauge(const char* name, const char* help) {
    return prometheus::BuildGauge().Name(name).Help(help).Register(registry).Add({});
  }
};

Metrics::Metrics() : impl_(std::make_unique<Impl>()) {}
Metrics::~Metrics() = default;

void Metrics::observe(const http::Exchange& exchange) {
  const std::string route = exchange.route.empty() ? "none" : exchange.route;
  // Methods come from the caller; only those of the contract may make a series.
  const std::string method = exchange.route.empty() ? "any" : exchange.method;
  impl_->requests.Add({{"method", method}, {"route", route}, {"status", std::to_string(exchange.status)}}).Increment();
  impl_->latency.Add({{"route", route}}, kSeconds).Observe(exchange.seconds);
}

void Metrics::add_frame(double trace_ms) {
  impl_->frames.Increment();
  impl_->trace.Observe(trace_ms * 1e-3);
}

void Metrics::add_rays(double count) {
  impl_->rays.Increment(count);
}

std::string Metrics::text(const Gauges& gauges) {
  impl_->queue_depth.Set(gauges.queue_depth);
  impl_->jobs_queued.Set(gauges.jobs_queued);
  impl_->scenes.Set(gauges.scenes);
  impl_->structures.Set(gauges.structures);
  impl_->resident_bytes.Set(gauges.resident_bytes);
  impl_->device_total.Set(static_cast<double>(gauges.device_memory.total_bytes));
  impl_->device_free.Set(static_cast<double>(gauges.device_memory.free_bytes));
  impl_->device_resident.Set(static_cast<double>(gauges.device_memory.resident_bytes));
  return prometheus::TextSerializer().Serialize(impl_->registry.Collect());
}

}  // namespace raywalk::api
