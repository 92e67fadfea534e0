// Plans of both parts, and one progress over them.
#include "server/bench/session.h"

#include <spdlog/spdlog.h>

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
    for (const Subject& subject : subjects) techniques_.emplace_back(hold, spec, scene, subject, last_);
    for (Noted& technique : techniques_) pointers_.push_back(&technique);
  }
  /// In the order of the subjects.
  const std::vector<Technique*>& all() const { return pointers_; }
  /// The one that measured last.
  Technique* last() const { return last_; }

 private:
  class Noted : public DeviceTechnique {
   public:
    Noted(DeviceQueue::Hold& hold, const BenchmarkSpec& spec, const LoadedScene& scene, const Subject& subject,
          Technique*& last)
        : DeviceTechnique(hold, spec, scene, subject), last_(last) {}
    double measure(u32 first, u32 frames) override {
      last_ = this;
      return DeviceTechnique::measure(first, frames);
    }

   private:
    Technique*& last_;
  };

  Technique* last_ = nullptr;
  std::vector<Noted> techniques_;
  std::vector<Technique*> pointers_;
};

std::string stage_text(const std::string& what, std::span<const Subject> subjects) {
  if (subjects.size() == 1) return what + " " + subjects[0].name;
  return what + " " + std::to_string(subjects.size()) + " combinations in turns";
}

std::string name_of(const Subject& subject) {
  return subject.name + " in mode " + mode_name(subject.mode);
}

/// One benchmark's session while it is measured.
class Measuring {
 public:
  Measuring(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
            DeviceQueue::Hold& hold, const std::function<void(const SessionProgress&)>& report, Session& out)
      : spec_(spec), subjects_(subjects), report_(report), techniques_(hold, spec, scene, subjects), out_(out) {}

  void single_frames(const MeasurePlan& plan) {
    const u64 warmup = subjects_.size() * plan.warmup;
    const std::string measuring = stage_text("measuring", subjects_);
    out_.single = measure(techniques_.all(), plan, [&](u64 done, u64) {
      report_({done < warmup ? "warming up " + subjects_[done / plan.warmup].name : measuring, done, out_.frames});
    });
    done_ = subjects_.size() * plan.total_frames();
  }

  /// Where the device's memory ends, launches become smaller, for all alike so that they can be compared; what has not
  /// room for two frames is left out.
  void batches(MeasurePlan plan) {
    const u32 wanted = plan.per_launch;
    std::vector<Technique*> active = techniques_.all();
    while (!active.empty()) {
      try {
        measure_batches(active, plan);
        break;
      } catch (const OutOfDeviceMemory& e) {
        spdlog::warn("a launch of {} frames: {}", plan.per_launch, e.what());
        if (plan.per_launch > 2) {
          plan.per_launch = std::max(2u, plan.per_launch / 2);
        } else {
          std::erase(active, techniques_.last());
        }
      }
    }
    if (active.empty()) out_.frames = done_;
    if (!active.empty() && plan.per_launch < wanted) {
      out_.notes.push_back("Throughput was measured with " + std::to_string(plan.per_launch) +
                           " frames a launch, not " + std::to_string(wanted) +
                           ": the device has not enough memory for more.");
    }
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
      if (std::ranges::find(active, techniques_.all()[i]) != active.end()) continue;
      out_.notes.push_back("Throughput of " + name_of(subjects_[i]) +
                           " is missing: the device has not enough memory for two frames of it at once.");
    }
  }

 private:
  void measure_batches(const std::vector<Technique*>& active, MeasurePlan plan) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    plan.time_limit_s = std::max(0.0, spec_.time_limit_s - elapsed.count());
    out_.frames = done_ + active.size() * plan.total_frames();
    const std::string stage = stage_text("measuring throughput of", subjects_);
    Measurements measured = measure(active, plan, [&](u64 done, u64) { report_({stage, done_ + done, out_.frames}); });
    out_.frames_per_launch = plan.per_launch;
    out_.batched.emplace();
    out_.batched->reached_time_limit = measured.reached_time_limit;
    out_.batched->ms.resize(subjects_.size());
    for (std::size_t i = 0, next = 0; i < subjects_.size() && next < active.size(); ++i) {
      if (techniques_.all()[i] == active[next]) out_.batched->ms[i] = std::move(measured.ms[next++]);
    }
  }

  const BenchmarkSpec& spec_;
  std::span<const Subject> subjects_;
  const std::function<void(const SessionProgress&)>& report_;
  Techniques techniques_;
  Session& out_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  u64 done_ = 0;  // frames of all subjects, before the batches
};

}  // namespace

u32 frames_per_launch(const BenchmarkSpec& spec, const Device& device) {
  return std::min({spec.batch, device.max_batch(), spec.frames});
}

Session measure_alone(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                      DeviceQueue& queue, const std::function<void(const SessionProgress&)>& report) {
  const Device& device = queue.device();
  const MeasurePlan single{spec.frames, 1, spec.warmup, spec.repeats, spec.time_limit_s};
  const MeasurePlan batched{spec.frames, frames_per_launch(spec, device), std::min(spec.warmup, 1u), spec.repeats, 0};
  const bool has_batches = batched.per_launch >= 2;
  Session out;
  out.frames = subjects.size() * (single.total_frames() + (has_batches ? batched.total_frames() : 0));

  report({"waiting for the device", 0, out.frames});
  DeviceQueue::Hold hold = queue.hold();
  Measuring measuring(spec, scene, subjects, hold, report, out);
  TelemetrySampler sampler(device);
  measuring.single_frames(single);
  if (has_batches) measuring.batches(batched);
  out.telemetry = summarise_readings(sampler.stop());
  for (const Subject& subject : subjects) {
    const FrameJob job = frame_job(spec, scene, subject, 0);
    out.kernels.push_back(hold.run([&](Device& d) { return d.kernel_figures(job, work_of(subject.mode)); }));
  }
  return out;
}

}  // namespace raywalk
