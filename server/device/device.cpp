// Errors of devices.
#include "server/device/device.h"

namespace raywalk {

OutOfDeviceMemory::OutOfDeviceMemory(u64 needed_bytes, u64 free_bytes)
    : std::runtime_error("The device has not enough memory for this: " + std::to_string(needed_bytes) +
                         " bytes are needed, and " + std::to_string(free_bytes) + " are free."),
      needed_bytes_(needed_bytes),
      free_bytes_(free_bytes) {}

}  // namespace raywalk
