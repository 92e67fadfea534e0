// From the flags to the device that renders, and the one whose results it is compared with.
#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/device/device.h"
#include "server/flags.h"

namespace raywalk {

struct Devices {
  std::unique_ptr<Device> rendering;
  std::unique_ptr<Device> reference;  // a CPU beside a GPU; null where the CPU renders: it is its own
  std::string no_cuda;                // why --device auto did not find a GPU; empty otherwise
  std::vector<std::string> warnings;  // for the people who use the daemon
};

/// The device that the flags ask for cannot be had; `what` is one sentence for the person who started the daemon.
class NoDevice : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `crashed_device` is the kind of device that the daemon before had when it crashed, or empty. Throws NoDevice. What
/// auto falls back to is logged.
Devices open_devices(const Flags& flags, const std::string& crashed_device);

}  // namespace raywalk
