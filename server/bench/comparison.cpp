// Both engines trace and render, the oracle judges where they differ.
#include "server/bench/comparison.h"

#include <algorithm>
#include <stdexcept>

#include "server/bench/shadow_rays.h"
#include "server/device/camera.h"

namespace raywalk {
namespace {

constexpr u64 kShadowRays = 100'000;  // of a frame

RayJob ray_job(const Subject& subject, std::span<const Ray> rays) {
  return {subject.structure.structure, subject.technique.traversal, rays, subject.kernel};
}

}  // namespace

TechniqueSpec reference_of(const TechniqueSpec& technique) {
  if (technique.structure == "embree") return {"bvh", "while-while"};
  return {"embree", "intersect", {{"robust", "on"}}};  // watertight, as ours are: what remains are real differences
}

std::vector<u32> compared_frames(const BenchmarkSpec& spec) {
  const u32 count = std::min(spec.error_frames, spec.frames);
  std::vector<u32> frames;
  for (u32 i = 0; i < count; ++i) frames.push_back(spaced_frame(i, count, spec.frames));
  return frames;
}

Comparison::Comparison(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> references,
                       DeviceQueue& queue, DeviceQueue& reference_queue)
    : spec_(spec),
      scene_(scene),
      references_(references),
      queue_(queue),
      reference_queue_(reference_queue),
      judge_(SceneView{scene.blob->data()}) {}

void Comparison::add_rays(const Subject& subject, u32 frame, ErrorFigures& figures) {
  const Subject& reference = reference_for(subject);
  const std::vector<Hit>& expected = reference_hits(reference, frame);
  const FrameJob job = frame_job(spec_, scene_, subject, frame);
  queue_.run([&](Device& device) { device.trace_primary(job, hits_); });
  figures.primary.rays += hits_.hits.size();
  const Camera camera = camera_of(job.camera, job.width, job.height);
  for (const u32 pixel : compare_hits(expected, hits_.hits, figures)) {
    const Ray ray = primary_ray(camera, pixel % job.width, pixel / job.width);
    judge_.judge(ray, hits_.hits[pixel], expected[pixel], figures.primary);
  }
  if (has_shadows(subject.mode)) add_shadow_rays(subject, reference, job, figures.shadow);
}

void Comparison::add_image(const Subject& subject, u32 frame, ErrorFigures& figures) {
  if (subject.mode == BenchMode::trace) return;
  const FrameJob job = frame_job(spec_, scene_, subject, frame);
  queue_.run([&](Device& device) { device.render(job, image_); });
  compare_images(reference_image(reference_for(subject), subject.mode, frame), image_, figures);
}

const Subject& Comparison::reference_for(const Subject& subject) const {
  const TechniqueSpec wanted = reference_of(subject.technique);
  for (const Subject& reference : references_) {
    if (reference.technique.structure == wanted.structure) return reference;
  }
  throw std::logic_error("no reference for " + subject.name);
}

Comparison::Reference& Comparison::at(const Subject& reference, u32 frame) {
  if (frame != frame_) current_.clear();
  frame_ = frame;
  return current_[&reference];
}

const std::vector<Hit>& Comparison::reference_hits(const Subject& reference, u32 frame) {
  std::vector<Hit>& hits = at(reference, frame).hits;
  if (hits.empty()) {
    PrimaryHits traced;
    const FrameJob job = frame_job(spec_, scene_, reference, frame);
    reference_queue_.run([&](Device& device) { device.trace_primary(job, traced); });
    hits = std::move(traced.hits);
  }
  return hits;
}

const Frame& Comparison::reference_image(const Subject& reference, BenchMode mode, u32 frame) {
  Frame& image = at(reference, frame).images[mode];
  if (image.pixels.empty()) {
    Subject subject = reference;
    subject.mode = mode;
    const FrameJob job = frame_job(spec_, scene_, subject, frame);
    reference_queue_.run([&](Device& device) { device.render(job, image); });
  }
  return image;
}

void Comparison::add_shadow_rays(const Subject& subject, const Subject& reference, const FrameJob& job,
                                 RayVerdicts& verdicts) {
  const ShadowRays shadows = shadow_rays(SceneView{scene_.blob->data()}, job, hits_.hits, kShadowRays);
  const RayJob own = ray_job(subject, shadows.rays), other = ray_job(reference, shadows.rays);
  const std::vector<u8> occluded = queue_.run([&](Device& device) { return device.occluded(own); });
  const std::vector<Hit> closest = queue_.run([&](Device& device) { return device.closest(own); });
  const std::vector<u8> expected = reference_queue_.run([&](Device& device) { return device.occluded(other); });
  verdicts.rays += shadows.rays.size();
  for (std::size_t i = 0; i < shadows.rays.size(); ++i) {
    if (occluded[i] != 0 && closest[i].id == shadows.origins[i]) {
      ++verdicts.self_hits;
    } else if ((occluded[i] != 0) != (expected[i] != 0)) {
      judge_.judge_occluded(shadows.rays[i], occluded[i] != 0, verdicts);
    }
  }
}

}  // namespace raywalk
