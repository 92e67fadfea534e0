// The sensors of a GPU, by NVML where it can be opened.
#pragma once
#include <optional>

#include "server/device/cuda/nvml_api.h"
#include "server/device/device.h"

namespace raywalk::cuda {

class Sensors {
 public:
  /// Of the GPU at `pci_bus_id`.
  explicit Sensors(const std::string& pci_bus_id);
  /// Nothing where there is no NVML, where it does not know the GPU, and where a clock, the power, its limit or the
  /// temperature cannot be read. Throttle reasons that cannot be read are "unknown". From any thread.
  std::optional<Telemetry> read() const;
  /// One sentence why the first reading gave nothing; empty when it gave something.
  const std::string& why_not() const { return why_not_; }
  /// Such as "580.95.05"; empty when unknown.
  std::string driver_version() const;

 private:
  std::shared_ptr<const NvmlApi> nvml_;
  nvmlDevice_t device_ = nullptr;
  std::string why_not_;
};

}  // namespace raywalk::cuda
