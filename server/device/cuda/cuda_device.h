// The device of an NVIDIA GPU: structures are built on the host and traversed by kernels compiled at run time.
#pragma once
#include <optional>

#include "server/device/cpu/tile_runner.h"
#include "server/device/cuda/kernel_store.h"
#include "server/device/cuda/readback.h"
#include "server/device/cuda/residency.h"
#include "server/device/cuda/sensors.h"

namespace raywalk::cuda {

class CudaStructure;

/// Calls throw OutOfDeviceMemory, CompileError, and DeviceLost from the first time on that the driver reports a failure
/// that only a new process can mend.
class CudaDevice final : public Device {
 public:
  /// `details` as DeviceInfo has them, completed here. Throws CudaError and CompileError when the GPU cannot be used.
  CudaDevice(std::shared_ptr<const Context> context, std::shared_ptr<const Compiler> compiler,
             std::map<std::string, std::string> details, const CudaConfig& config);

  const DeviceInfo& info() const override { return info_; }
  const std::vector<KindInfo>& kinds() const override { return kinds_; }
  std::shared_ptr<const Structure> build(std::shared_ptr<const Blob> scene, const std::string& kind,
                                         const OptionValues& options) override;
  void render(const FrameJob& job, Frame& frame) override;
  void trace_primary(const FrameJob& job, PrimaryHits& result) override;
  u32 max_batch() const override { return FrameBatch::kMax; }
  double measure(std::span<const FrameJob> jobs, Work work) override;
  std::optional<KernelFigures> kernel_figures(const FrameJob& job, Work work) override;
  std::optional<Telemetry> telemetry() const override { return sensors_.read(); }
  DeviceMemory memory() const override;
  Counts count(const FrameJob& job) override;
  bool can_count(const std::string& kind) const override;
  std::vector<Hit> closest(const RayJob& job) override;
  std::vector<Counts> count_rays(const RayJob& job) override;
  std::vector<u8> occluded(const RayJob& job) override;
  std::vector<double> measure_rays(const RayJob& job, RayQuery query, u32 launches) override;

 private:
  struct OnDevice {
    Residency::Held scene, structure;
  };

  /// Runs `work`, once more if the driver's own needs found no memory; failures become those of Device.
  template <class Work>
  auto guarded(Work work);
  [[noreturn]] void rethrow(const CudaError& error);

  OnDevice hold(const CudaStructure& structure);
  OnDevice hold(const FrameJob& job);
  KernelSpec spec_of(const FrameJob& job, Program program) const;
  /// Colours of all jobs, one frame after another, into `pixels`; the time in ms.
  double shade(std::span<const FrameJob> jobs, const OnDevice& data, const Residency::Scratch& pixels);
  /// Closest hits of the primary rays of all jobs into `hits`, padded_rays() a frame; the time in ms.
  double trace(std::span<const FrameJob> jobs, const OnDevice& data, const Residency::Scratch& hits);
  void render_steps(const FrameJob& job, Frame& frame);
  /// Primary rays of all jobs, padded_rays() a frame; queued only.
  Residency::Scratch primary_rays(std::span<const FrameJob> jobs);
  template <class... Arguments>
  double timed(Kernel& kernel, const Grid& grid, const Arguments&... arguments);
  template <class Answer>
  std::vector<Answer> answers(const RayJob& job, Program program, const char* entry);

  std::shared_ptr<const Context> context_;
  std::shared_ptr<const Stream> stream_;
  std::shared_ptr<Residency> memory_;
  KernelStore kernels_;
  Launcher launch_;
  Timer timer_;
  Readback readback_;
  Sensors sensors_;
  TileRunner host_;
  DeviceInfo info_;
  std::vector<KindInfo> kinds_;
  bool all_features_;
  std::vector<Hit> hits_;  // reused from frame to frame
  std::optional<std::string> lost_;
};

}  // namespace raywalk::cuda
