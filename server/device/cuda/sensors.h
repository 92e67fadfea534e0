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
  /// Nothing where there is no NVML, or where it does not know the GPU. From any thread.
  std::optional<Telemetry> read() const;
  /// Such as "580.95.05"; empty when unknown.
  std::string driver_version() const;

 private:
  std::shared_ptr<const NvmlApi> nvml_;
  nvmlDevice_t device_ = nullptr;
};

}  // namespace raywalk::cuda
