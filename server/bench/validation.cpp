// Frame by frame, so that one reference frame is in memory at a time.
#include "server/bench/validation.h"

#include <map>

namespace raywalk {
namespace {

void count_work(const Subject& subject, const FrameJob& job, DeviceQueue& queue, Validation& out) {
  if (subject.baseline) {
    out.counts.rays += u64{job.width} * job.height;
    out.counts_work = false;
    return;
  }
  queue.run([&](Device& device) {
    out.counts += device.count(job);
    out.counts_work = device.can_count(subject.technique.structure);
  });
}

}  // namespace

std::vector<Validation> validate(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> subjects,
                                 Comparison& comparison, DeviceQueue& queue,
                                 const std::function<void(double fraction)>& before_frame) {
  const std::vector<u32> frames = compared_frames(spec);
  std::vector<Validation> out(subjects.size());
  double done = 0;
  for (const u32 frame : frames) {
    // By structure, technique and whether there are shadow rays: the same in every mode.
    std::map<std::string, ErrorFigures> of_rays;
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      before_frame(done++ / static_cast<double>(subjects.size() * frames.size()));
      const Subject& subject = subjects[s];
      const std::string key = subject.structure.id + " " + subject.name + (has_shadows(subject.mode) ? " shadows" : "");
      const auto [found, first] = of_rays.try_emplace(key);
      if (first) comparison.add_rays(subject, frame, found->second);
      ErrorFigures& error = out[s].error;
      error.add_rays(found->second);
      error.reference = comparison.reference_for(subject).name;
      ++error.frames;
      comparison.add_image(subject, frame, error);
      count_work(subject, frame_job(spec, scene, subject, frame), queue, out[s]);
    }
  }
  return out;
}

}  // namespace raywalk
