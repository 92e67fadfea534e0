// One technique in one mode on one scene, as the measuring loop and the validation use it.
#pragma once
#include "server/bench/benchmark.h"
#include "server/bench/measure.h"

namespace raywalk {

/// One row of the result in the making.
struct Subject {
  TechniqueSpec technique;
  BenchMode mode = BenchMode::primary;
  StructureRecord structure;
  OptionValues kernel;          // complete
  std::string changed_options;  // of builder and kernel, that are not the default: " name=value" each
  std::string name;             // <structure>/<traversal>, and those
  bool baseline = false;        // its rays are known, its work cannot be counted
  GateTerms terms;
  std::optional<KnobChoice> choice = {};  // of tier auto, when it is made
};

/// `technique` is valid, and `structure` its built structure.
Subject make_subject(const TechniqueSpec& technique, BenchMode mode, StructureRecord structure,
                     const std::vector<KindInfo>& kinds);

/// Gives the subject these complete options of its kernel, and the names and terms that follow from them.
void set_kernel(Subject& subject, const KindInfo& kind, const TraversalInfo& traversal, const OptionValues& kernel);

/// Whether the mode's frames have shadow rays.
bool has_shadows(BenchMode mode);

/// The job of frame `frame` of `spec.frames`; mode trace is a primary one.
FrameJob frame_job(const BenchmarkSpec& spec, const LoadedScene& scene, const Subject& subject, u32 frame);

/// What the device does when it measures a frame of this mode.
Work work_of(BenchMode mode);

/// Which of `error_frames` evenly spaced frames: `index` of `count` among `frames`.
u32 spaced_frame(u32 index, u32 count, u32 frames);

/// Measures a subject with the device held.
class DeviceTechnique : public Technique {
 public:
  DeviceTechnique(DeviceQueue::Hold& hold, const BenchmarkSpec& spec, const LoadedScene& scene, const Subject& subject)
      : hold_(hold), spec_(spec), scene_(scene), subject_(subject) {}
  double measure(u32 first, u32 frames) override;

 private:
  DeviceQueue::Hold& hold_;
  const BenchmarkSpec& spec_;
  const LoadedScene& scene_;
  const Subject& subject_;
  std::vector<FrameJob> jobs_;  // storage, used again
};

}  // namespace raywalk
