// A device of the tests: no geometry, predictable answers.
#pragma once
#include <atomic>
#include <chrono>
#include <thread>

#include "server/device/device.h"

namespace raywalk::test {

class FakeStructure : public Structure {
 public:
  explicit FakeStructure(std::string kind) : kind_(std::move(kind)) { stats_.references = 3; }
  const std::string& kind() const override { return kind_; }
  const BuildStats& stats() const override { return stats_; }

 private:
  std::string kind_;
  BuildStats stats_;
};

class FakeDevice : public Device {
 public:
  const DeviceInfo& info() const override { return info_; }
  const std::vector<KindInfo>& kinds() const override { return kinds_; }
  std::shared_ptr<const Structure> build(std::shared_ptr<const Blob>, const std::string& kind,
                                         const OptionValues&) override {
    ++builds;
    std::this_thread::sleep_for(build_time);
    if (fail_builds) throw std::runtime_error("it fell over");
    return std::make_shared<FakeStructure>(kind);
  }
  void render(const FrameJob& job, Frame& frame) override {
    frame = {job.width, job.height, 3, std::vector<float>(3ull * job.width * job.height, 0.5f), 2.0, 0.0};
  }
  void trace_primary(const FrameJob& job, PrimaryHits& hits) override {
    hits.hits.assign(std::size_t{job.width} * job.height, Hit{1, 0, 0, 0});
    hits.trace_ms = 1.0;
  }
  u32 max_batch() const override { return 16; }
  double measure(std::span<const FrameJob> jobs, Work work) override {
    launches.push_back(jobs.size());
    const double frame_ms = work == Work::trace ? 1.0 : 2.0;
    return jobs.size() == 1 ? frame_ms : 0.5 * frame_ms * static_cast<double>(jobs.size());
  }
  std::optional<KernelFigures> kernel_figures(const FrameJob&, Work) override { return KernelFigures{}; }
  std::optional<Telemetry> telemetry() const override { return std::nullopt; }
  DeviceMemory memory() const override { return {}; }
  Counts count(const FrameJob& job) override {
    const u64 rays = u64{job.width} * job.height;
    return {rays, 10 * rays, 2 * rays};
  }
  bool can_count(const std::string& kind) const override { return kind != "embree"; }
  std::vector<Hit> closest(const RayJob& job) override { return std::vector<Hit>(job.rays.size()); }
  std::vector<u8> occluded(const RayJob& job) override { return std::vector<u8>(job.rays.size()); }

  std::atomic<int> builds{0};
  std::chrono::milliseconds build_time{0};
  bool fail_builds = false;
  std::vector<std::size_t> launches;  // frames of each measurement

 private:
  DeviceInfo info_{.name = "fake", .kind = "cpu"};
  std::vector<KindInfo> kinds_ = {
      {"bvh",
       "",
       {{.name = "bins", .help = "", .default_value = 32, .min = 2, .max = 64, .integer = true},
        {.name = "cost", .help = "", .default_value = 1.5, .min = 0.5, .max = 8},
        {.name = "split", .help = "", .default_value = 0, .min = 0, .max = 1, .choices = {"sah", "middle"}}},
       {{"while-while", "", false}}},
      {"embree",
       "",
       {{.name = "robust", .help = "", .max = 1, .choices = {"off", "on"}}},
       {{"intersect", "", false}, {"bare", "", true}}}};
};

}  // namespace raywalk::test
