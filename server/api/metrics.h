// Prometheus metrics of the daemon.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "server/device/device.h"
#include "server/http/server.h"

namespace raywalk::api {

class Metrics {
 public:
  Metrics();
  ~Metrics();

  void observe(const http::Exchange& exchange);
  void add_frame(double trace_ms);
  void add_rays(double count);

  /// What is asked for when the metrics are.
  struct Gauges {
    double queue_depth = 0, jobs_queued = 0, scenes = 0, structures = 0, resident_bytes = 0;
    DeviceMemory device_memory = {};
  };
  /// The text form of all metrics.
  std::string text(const Gauges& gauges);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace raywalk::api
