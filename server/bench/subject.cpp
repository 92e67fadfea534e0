// Frames of a walkthrough for one technique.
#include "server/bench/subject.h"

#include <sstream>

namespace raywalk {

std::string Subject::name() const {
  std::ostringstream text;
  text << technique.structure << '/' << technique.traversal;
  for (const auto& [option, value] : technique.options) {
    std::visit([&, &key = option](const auto& shown) { text << ' ' << key << '=' << shown; }, value);
  }
  return text.str();
}

FrameJob frame_job(const BenchmarkSpec& spec, const LoadedScene& scene, const Subject& subject, u32 frame) {
  FrameJob job;
  job.structure = subject.structure.structure;
  job.traversal = subject.technique.traversal;
  job.camera = pose_at(scene.camera_path, frame, spec.frames);
  job.width = spec.width;
  job.height = spec.height;
  job.mode = subject.mode == BenchMode::shadow    ? Mode::shadow
             : subject.mode == BenchMode::whitted ? Mode::whitted
                                                  : Mode::primary;
  job.depth = spec.depth;
  return job;
}

u32 spaced_frame(u32 index, u32 count, u32 frames) {
  return static_cast<u32>(u64{index} * frames / count);
}

double DeviceTechnique::measure(u32 frame) {
  const FrameJob job = frame_job(spec_, scene_, subject_, frame);
  return hold_.run([&](Device& device) {
    if (subject_.mode == BenchMode::trace) {
      device.trace_primary(job, hits_);
      return hits_.trace_ms;
    }
    device.render(job, frame_);
    return frame_.trace_ms;
  });
}

}  // namespace raywalk
