// The GPU of this machine for tests that need a real one, with the CPU beside it.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>

#include "server/device/device.h"

namespace raywalk::test {

inline DeviceOrReason open_gpu(const CudaConfig& config = {}) {
  if (std::getenv("RAYWALK_LIBCUDA") != nullptr) return {nullptr, "RAYWALK_LIBCUDA names a driver that may be a fake"};
  return open_cuda_device(config);
}

/// Skips, with the reason, where there is no GPU.
class GpuTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    opened_ = new DeviceOrReason(open_gpu());
    cpu_ = open_cpu_device(0).release();
  }
  static void TearDownTestSuite() {
    delete opened_;
    delete cpu_;
  }
  void SetUp() override {
    if (!opened_->device) GTEST_SKIP() << opened_->why_not;
  }
  static Device& gpu() { return *opened_->device; }
  static Device& cpu() { return *cpu_; }

 private:
  static inline DeviceOrReason* opened_ = nullptr;
  static inline Device* cpu_ = nullptr;
};

}  // namespace raywalk::test
