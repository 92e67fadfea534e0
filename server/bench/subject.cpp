// Frames of a walkthrough for one technique.
#include "server/bench/subject.h"

namespace raywalk {
namespace {

GateTerms terms_of(Tier tier, const TraversalInfo& traversal, const OptionValues& kernel) {
  if (!has_tiers(traversal)) return {};
  const bool is_its_own = tier == Tier::automatic || is_of_tier(traversal, tier, kernel);
  return {is_its_own ? tier_name(tier) : "custom", limit_ppm(tier)};
}

}  // namespace

Subject make_subject(const TechniqueSpec& technique, BenchMode mode, StructureRecord structure,
                     const std::vector<KindInfo>& kinds) {
  const KindInfo& kind = kind_named(kinds, technique.structure, "");
  const TraversalInfo& traversal = traversal_named(kind, technique.traversal, "");
  Subject subject;
  subject.technique = technique;
  subject.mode = mode;
  subject.structure = std::move(structure);
  subject.baseline = traversal.baseline;
  set_kernel(subject, kind, traversal, kernel_options(kind, traversal, technique.tier, technique.kernel, ""));
  return subject;
}

void set_kernel(Subject& subject, const KindInfo& kind, const TraversalInfo& traversal, const OptionValues& kernel) {
  subject.kernel = kernel;
  subject.changed_options = changed_options(kind.options, complete_options(kind, subject.technique.options, "")) +
                            changed_options(traversal.options, kernel);
  subject.name = kind.name + "/" + traversal.name + subject.changed_options;
  subject.terms = terms_of(subject.technique.tier, traversal, kernel);
}

bool has_shadows(BenchMode mode) {
  return mode == BenchMode::shadow || mode == BenchMode::whitted;
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
  job.kernel = subject.kernel;
  return job;
}

Work work_of(BenchMode mode) {
  return mode == BenchMode::trace ? Work::trace : Work::frame;
}

u32 spaced_frame(u32 index, u32 count, u32 frames) {
  return static_cast<u32>(u64{index} * frames / count);
}

double DeviceTechnique::measure(u32 first, u32 frames) {
  jobs_.clear();
  for (u32 i = 0; i < frames; ++i) jobs_.push_back(frame_job(spec_, scene_, subject_, first + i));
  return hold_.run([&](Device& device) { return device.measure(jobs_, work_of(subject_.mode)); });
}

}  // namespace raywalk
