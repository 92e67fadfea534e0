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
  std::string name() const override { return "fake"; }
  u32 threads() const override { return 1; }
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

 private:
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
