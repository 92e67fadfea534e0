// One kind of structure as the CPU device holds it: its builder and its traversals, of the kernels or of Embree.
#pragma once
#include <memory>
#include <vector>

#include "kernels/entry_cpu.h"
#include "server/device/device.h"

namespace raywalk {

/// A structure that CpuTraversal rows can be called with.
class CpuStructure : public Structure {
 public:
  CpuStructure(std::shared_ptr<const Blob> scene, std::string kind, BuildStats stats)
      : scene_(std::move(scene)), kind_(std::move(kind)), stats_(stats) {}
  const std::string& kind() const override { return kind_; }
  const BuildStats& stats() const override { return stats_; }
  SceneView scene() const { return {scene_->data()}; }
  /// What the traversals of this kind take as `structure`.
  virtual const void* handle() const = 0;

 protected:
  std::shared_ptr<const Blob> scene_;

 private:
  std::string kind_;
  BuildStats stats_;
};

/// A loop that generates primary rays and traces them, nothing else: the ceiling of an engine.
struct BareLoop {
  std::string_view name, help;
  /// Hits of a tile into the frame's `hits` (width * height, rows top down).
  void (*trace)(const void* structure, const FrameArgs& args, Tile tile, Hit* hits);
};

struct CpuKind {
  KindInfo info;
  std::shared_ptr<const CpuStructure> (*build)(std::shared_ptr<const Blob> scene, const Kind* kind,
                                               const OptionValues& options);
  const Kind* kind = nullptr;  // of the kernels; null for an engine
  std::vector<CpuTraversal> traversals;
  std::vector<BareLoop> loops = {};
  bool counts_work = true;  // whether its traversals can count steps and tests
};

/// A kind for each of the kernels' kinds.
std::vector<CpuKind> kernel_kinds();

/// Embree 3 or 4: `embree/intersect`, and the bare loops over it.
CpuKind embree_kind();

}  // namespace raywalk
