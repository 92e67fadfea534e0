// Frame by frame, so that one reference frame is in memory at a time.
#include "server/bench/validation.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace raywalk {
namespace {

/// Hits and images of one reference at one frame, made when first asked for.
class ReferenceFrame {
 public:
  ReferenceFrame(const BenchmarkSpec& spec, const LoadedScene& scene, const Subject& subject, u32 frame,
                 DeviceQueue& queue)
      : spec_(spec), scene_(scene), subject_(subject), frame_(frame), queue_(queue) {}

  const std::vector<Hit>& hits() {
    if (hits_.hits.empty()) {
      const FrameJob job = frame_job(spec_, scene_, subject_, frame_);
      queue_.run([&](Device& device) { device.trace_primary(job, hits_); });
    }
    return hits_.hits;
  }
  const Frame& image(BenchMode mode) {
    Frame& image = images_[mode];
    if (image.pixels.empty()) {
      Subject subject = subject_;
      subject.mode = mode;
      const FrameJob job = frame_job(spec_, scene_, subject, frame_);
      queue_.run([&](Device& device) { device.render(job, image); });
    }
    return image;
  }

 private:
  const BenchmarkSpec& spec_;
  const LoadedScene& scene_;
  const Subject& subject_;
  u32 frame_;
  DeviceQueue& queue_;
  PrimaryHits hits_;
  std::map<BenchMode, Frame> images_;
};

void add(Counts& sum, const Counts& counts) {
  sum.rays += counts.rays;
  sum.steps += counts.steps;
  sum.tests += counts.tests;
}

void count_work(const Subject& subject, const FrameJob& job, DeviceQueue& queue, Validation& out) {
  if (subject.baseline) {
    out.counts.rays += u64{job.width} * job.height;
    out.counts_work = false;
    return;
  }
  queue.run([&](Device& device) {
    add(out.counts, device.count(job));
    out.counts_work = device.can_count(subject.technique.structure);
  });
}

const Subject& reference_for(const Subject& subject, std::span<const Subject> references) {
  const TechniqueSpec wanted = reference_of(subject.technique);
  for (const Subject& reference : references) {
    if (reference.technique.structure == wanted.structure) return reference;
  }
  throw std::logic_error("no reference for " + subject.name);
}

}  // namespace

TechniqueSpec reference_of(const TechniqueSpec& technique) {
  if (technique.structure == "embree") return {"bvh", "while-while"};
  return {"embree", "intersect", {{"robust", "on"}}};  // watertight, as ours are: what remains are real differences
}

std::vector<Validation> validate(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                                 std::span<const Subject> references, DeviceQueue& queue, DeviceQueue& reference_queue,
                                 const std::function<void(double fraction)>& before_frame) {
  const u32 frames = std::min(spec.error_frames, spec.frames);
  std::vector<Validation> out(subjects.size());
  PrimaryHits hits;
  Frame image;
  for (u32 i = 0; i < frames; ++i) {
    const u32 frame = spaced_frame(i, frames, spec.frames);
    std::map<const Subject*, ReferenceFrame> reference_frames;
    std::map<std::string, ErrorFigures> hit_errors;  // by structure and technique: the same in every mode
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      before_frame((static_cast<double>(i) + static_cast<double>(s) / static_cast<double>(subjects.size())) / frames);
      const Subject& subject = subjects[s];
      const Subject& reference = reference_for(subject, references);
      auto& reference_frame =
          reference_frames.try_emplace(&reference, spec, scene, reference, frame, reference_queue).first->second;
      const FrameJob job = frame_job(spec, scene, subject, frame);

      const auto [hit_error, first] = hit_errors.try_emplace(subject.structure.id + " " + subject.name);
      if (first) {
        queue.run([&](Device& device) { device.trace_primary(job, hits); });
        compare_hits(reference_frame.hits(), hits.hits, hit_error->second);
      }
      ErrorFigures& error = out[s].error;
      error.reference = reference.name;
      error.frames = frames;
      error.pixels += hit_error->second.pixels;
      error.id_mismatches += hit_error->second.id_mismatches;
      error.ties += hit_error->second.ties;
      if (subject.mode != BenchMode::trace) {
        queue.run([&](Device& device) { device.render(job, image); });
        compare_images(reference_frame.image(subject.mode), image, error);
      }
      count_work(subject, job, queue, out[s]);
    }
  }
  return out;
}

}  // namespace raywalk
