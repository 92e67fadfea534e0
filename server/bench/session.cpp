// Plans of both parts, and one progress over them.
#include "server/bench/session.h"

#include <algorithm>
#include <chrono>

namespace raywalk {
namespace {

/// Techniques of all subjects that measure with one hold.
class Techniques {
 public:
  Techniques(DeviceQueue::Hold& hold, const BenchmarkSpec& spec, const LoadedScene& scene,
             std::span<const Subject> subjects) {
    techniques_.reserve(subjects.size());
    for (const Subject& subject : subjects) {
      techniques_.emplace_back(hold, spec, scene, subject);
      pointers_.push_back(&techniques_.back());
    }
  }
  std::span<Technique* const> all() const { return pointers_; }

 private:
  std::vector<DeviceTechnique> techniques_;
  std::vector<Technique*> pointers_;
};

std::string stage_text(const std::string& what, std::span<const Subject> subjects) {
  if (subjects.size() == 1) return what + " " + subjects[0].name;
  return what + " " + std::to_string(subjects.size()) + " combinations in turns";
}

}  // namespace

u32 frames_per_launch(const BenchmarkSpec& spec, const Device& device) {
  return std::min({spec.batch, device.max_batch(), spec.frames});
}

Session measure_alone(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                      DeviceQueue& queue, const std::function<void(const SessionProgress&)>& report) {
  const Device& device = queue.device();
  MeasurePlan single{spec.frames, 1, spec.warmup, spec.repeats, spec.time_limit_s};
  MeasurePlan batched{spec.frames, frames_per_launch(spec, device), std::min(spec.warmup, 1u), spec.repeats, 0};
  const bool has_batches = batched.per_launch >= 2;
  Session out;
  out.frames = subjects.size() * (single.total_frames() + (has_batches ? batched.total_frames() : 0));

  report({"waiting for the device", 0, out.frames});
  DeviceQueue::Hold hold = queue.hold();
  const Techniques techniques(hold, spec, scene, subjects);
  TelemetrySampler sampler(device);
  const auto begin = std::chrono::steady_clock::now();
  const u64 warmup = subjects.size() * single.warmup;
  const std::string measuring = stage_text("measuring", subjects);
  out.single = measure(techniques.all(), single, [&](u64 done, u64) {
    report({done < warmup ? "warming up " + subjects[done / single.warmup].name : measuring, done, out.frames});
  });
  if (has_batches) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    batched.time_limit_s = std::max(0.0, spec.time_limit_s - elapsed.count());
    out.frames_per_launch = batched.per_launch;
    const u64 before = subjects.size() * single.total_frames();
    const std::string stage = stage_text("measuring throughput of", subjects);
    out.batched = measure(techniques.all(), batched, [&](u64 done, u64) {
      report({stage, before + done, out.frames});
    });
  }
  out.telemetry = summarise_readings(sampler.stop());
  for (const Subject& subject : subjects) {
    const FrameJob job = frame_job(spec, scene, subject, 0);
    out.kernels.push_back(hold.run([&](Device& d) { return d.kernel_figures(job, work_of(subject.mode)); }));
  }
  return out;
}

}  // namespace raywalk
