// A structure whose blob, and whose scene's, may lie on the GPU.
#pragma once
#include "server/device/cuda/residency.h"
#include "server/device/device.h"

namespace raywalk::cuda {

class CudaStructure final : public Structure {
 public:
  CudaStructure(std::string kind, const BuildStats& stats, StructureForm form, std::shared_ptr<Residency::Copy> scene,
                std::shared_ptr<Residency::Copy> structure)
      : kind_(std::move(kind)),
        stats_(stats),
        form_(form),
        scene_(std::move(scene)),
        structure_(std::move(structure)) {}

  const std::string& kind() const override { return kind_; }
  const BuildStats& stats() const override { return stats_; }
  StructureForm form() const override { return form_; }
  /// On the host.
  SceneView scene() const { return {scene_->blob().data()}; }
  const std::shared_ptr<Residency::Copy>& scene_copy() const { return scene_; }
  const std::shared_ptr<Residency::Copy>& copy() const { return structure_; }

 private:
  std::string kind_;
  BuildStats stats_;
  StructureForm form_;
  std::shared_ptr<Residency::Copy> scene_, structure_;
};

}  // namespace raywalk::cuda
