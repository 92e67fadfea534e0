// The measured engine beside the references, frame by frame.
#pragma once
#include <map>
#include <span>

#include "server/bench/errors.h"
#include "server/bench/subject.h"

namespace raywalk {

/// The technique that `subject` is compared with: watertight Embree, and bvh/while-while for Embree itself.
TechniqueSpec reference_of(const TechniqueSpec& technique);

/// Frames that a benchmark compares, evenly spaced.
std::vector<u32> compared_frames(const BenchmarkSpec& spec);

/// Keeps the references of one frame, so it is cheap to ask for all that is wanted of a frame before the next. All
/// arguments must live as long.
class Comparison {
 public:
  /// `references` has a structure for each reference that is needed, for the device of `reference_queue`.
  Comparison(const BenchmarkSpec& spec, const LoadedScene& scene, std::span<const Subject> references,
             DeviceQueue& queue, DeviceQueue& reference_queue);

  const Subject& reference_for(const Subject& subject) const;
  /// Traces the subject's primary rays of the frame, and in modes with shadows a share of their shadow rays.
  void add_rays(const Subject& subject, u32 frame, ErrorFigures& figures);
  /// Renders the frame; nothing in mode trace.
  void add_image(const Subject& subject, u32 frame, ErrorFigures& figures);

 private:
  struct Reference {
    std::vector<Hit> hits;  // of primary rays
    std::map<BenchMode, Frame> images;
  };
  const BenchmarkSpec& spec_;
  const LoadedScene& scene_;
  std::span<const Subject> references_;
  DeviceQueue& queue_;
  DeviceQueue& reference_queue_;
  Judge judge_;
  u32 frame_ = 0;                                // that the references are of
  std::map<const Subject*, Reference> current_;  // made when first asked for
  PrimaryHits hits_;                             // storage, used again, as is
  Frame image_;

  Reference& at(const Subject& reference, u32 frame);
  const std::vector<Hit>& reference_hits(const Subject& reference, u32 frame);
  const Frame& reference_image(const Subject& reference, BenchMode mode, u32 frame);
  void add_shadow_rays(const Subject& subject, const Subject& reference, const FrameJob& job, RayVerdicts& verdicts);
};

}  // namespace raywalk
