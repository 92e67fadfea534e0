// Errors of devices.
#include "server/device/device.h"

namespace raywalk {
namespace {

/// "12.3 MiB", rounded up for what is needed and down for what there is.
std::string mib(u64 bytes, bool up) {
  const u64 tenths = (bytes * 10 + (up ? (1u << 20) - 1 : 0)) >> 20;
  return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10) + " MiB";
}

std::string sentence(u64 needed_bytes, u64 free_bytes) {
  if (needed_bytes == 0) return "The device has run out of memory: " + mib(free_bytes, false) + " are free.";
  return "The device has not enough memory for this: " + mib(needed_bytes, true) + " are needed, and " +
         mib(free_bytes, false) + " are free.";
}

}  // namespace

OutOfDeviceMemory::OutOfDeviceMemory(u64 needed_bytes, u64 free_bytes)
    : std::runtime_error(sentence(needed_bytes, free_bytes)), needed_bytes_(needed_bytes), free_bytes_(free_bytes) {}

}  // namespace raywalk
