// A device of the tests: no geometry, predictable answers.
#pragma once
#include <atomic>
#include <chrono>
#include <map>
#include <string>
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
    if (memory_is_full) throw OutOfDeviceMemory(u64{2000} << 20, u64{1000} << 20);
    if (is_lost) throw DeviceLost("it fell off the bus");
    return std::make_shared<FakeStructure>(kind);
  }
  void render(const FrameJob& job, Frame& frame) override {
    if (is_lost) throw DeviceLost("it fell off the bus");
    frame = {job.width, job.height, 3, std::vector<float>(3ull * job.width * job.height, 0.5f), 2.0, 0.0};
  }
  void trace_primary(const FrameJob& job, PrimaryHits& hits) override {
    hits.hits.assign(std::size_t{job.width} * job.height, Hit{1, hit_id, 0, 0});
    hits.trace_ms = 1.0;
  }
  u32 max_batch() const override { return 16; }
  double measure(std::span<const FrameJob> jobs, Work work) override {
    if (jobs.size() > room_of(jobs.front().traversal)) throw OutOfDeviceMemory(2000, 1000);
    launches.push_back(jobs.size());
    kernels.push_back(jobs.front().kernel);
    const double frame_ms = work == Work::trace ? 1.0 : 2.0;
    return jobs.size() == 1 ? frame_ms : 0.5 * frame_ms * static_cast<double>(jobs.size());
  }
  std::optional<KernelFigures> kernel_figures(const FrameJob& job, Work) override {
    KernelFigures figures;
    figures.registers = static_cast<u32>(job.kernel.at("registers"));
    return figures;
  }
  std::optional<Telemetry> telemetry() const override {
    if (!has_sensors) return std::nullopt;
    return Telemetry{++readings, 2600, 300.0, 700.0, 50, {}};
  }
  DeviceMemory memory() const override { return {8000, 5000, 3000}; }
  Counts count(const FrameJob& job) override {
    const u64 rays = u64{job.width} * job.height;
    return {rays, 10 * rays, 2 * rays};
  }
  bool can_count(const std::string& kind) const override { return kind != "embree"; }
  std::vector<Hit> closest(const RayJob& job) override { return std::vector<Hit>(job.rays.size()); }
  std::vector<Counts> count_rays(const RayJob& job) override { return std::vector<Counts>(job.rays.size()); }
  std::vector<u8> occluded(const RayJob& job) override { return std::vector<u8>(job.rays.size()); }
  std::vector<double> measure_rays(const RayJob&, RayQuery, u32 count) override {
    return std::vector<double>(count, 1.0);
  }

  std::atomic<int> builds{0};
  std::chrono::milliseconds build_time{0};
  bool fail_builds = false;
  std::atomic<bool> memory_is_full{false}, is_lost{false};
  bool has_sensors = false;
  std::map<std::string, std::size_t> most_frames;  // of a launch that a traversal has memory for; absent: any number
  u32 hit_id = 0;                                  // of every ray
  std::vector<std::size_t> launches;               // frames of each measurement
  std::vector<OptionValues> kernels;               // options of each
  mutable std::atomic<u32> readings{0};            // of the sensors

 private:
  std::size_t room_of(const std::string& traversal) const {
    const auto limit = most_frames.find(traversal);
    return limit == most_frames.end() ? max_batch() : limit->second;
  }

  DeviceInfo info_{.name = "fake", .kind = "cpu"};
  std::vector<Option> kernel_options_ = {
      {.name = "registers", .help = "", .default_value = 0, .min = 0, .max = 255, .integer = true},
      {.name = "test", .help = "", .max = 1, .choices = {"watertight", "moeller"}},
      {.name = "block", .help = "", .default_value = 128, .min = 32, .max = 512, .integer = true, .step = 32}};
  std::vector<KindInfo> kinds_ = {
      {"bvh",
       "",
       {{.name = "bins", .help = "", .default_value = 32, .min = 2, .max = 64, .integer = true},
        {.name = "cost", .help = "", .default_value = 1.5, .min = 0.5, .max = 8},
        {.name = "split", .help = "", .default_value = 0, .min = 0, .max = 1, .choices = {"sah", "middle"}}},
       {{"while-while", "", false, kernel_options_}, {"pair", "", false, kernel_options_}}},
      {"embree",
       "",
       {{.name = "robust", .help = "", .max = 1, .choices = {"off", "on"}}},
       {{"intersect", "", false, kernel_options_}, {"bare", "", true, kernel_options_}}}};
};

}  // namespace raywalk::test
