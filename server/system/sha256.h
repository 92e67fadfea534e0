// SHA-256 (FIPS 180-4), for the identity of files, geometry and kernels.
#pragma once
#include <array>
#include <string>

#include "kernels/platform.h"

namespace raywalk {

class Sha256 {
 public:
  void add(const void* data, size_t size_bytes);
  /// 64 lower-case hex digits of everything added. Call once.
  std::string hex();

 private:
  void compress(const u8* block);

  std::array<u32, 8> state_{0x6a09e667u, 0xbb67ae85u, 0x3c6ef372u, 0xa54ff53au,
                            0x510e527fu, 0x9b05688cu, 0x1f83d9abu, 0x5be0cd19u};
  std::array<u8, 64> pending_{};
  u64 total_bytes_ = 0;
};

}  // namespace raywalk
