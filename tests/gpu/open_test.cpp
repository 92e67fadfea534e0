// Why there is no CUDA device, one sentence for each cause.
#include <gtest/gtest.h>

#include "server/device/cuda/nvrtc_api.h"
#include "server/device/device.h"
#include "tests/gpu/fake_driver.h"
#include "tests/support/environment.h"

namespace raywalk {
namespace {

using test::Variable;

std::string why_not() {
  const DeviceOrReason opened = open_cuda_device({});
  EXPECT_EQ(opened.device, nullptr);
  return opened.why_not;
}

void expect_part(const std::string& whole, const std::string& part) {
  EXPECT_NE(whole.find(part), std::string::npos) << whole;
}

TEST(OpenCudaDevice, WithoutADriver) {
  const Variable driver("RAYWALK_LIBCUDA", "/no/such/libcuda.so.1");
  expect_part(why_not(), "There is no NVIDIA driver.");
}

TEST(OpenCudaDevice, WithAnOldDriver) {
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda")), version("FAKE_CUDA_VERSION", "11040");
  expect_part(why_not(), "CUDA 11.4");
}

TEST(OpenCudaDevice, WithoutAGpu) {
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda")), devices("FAKE_CUDA_DEVICES", "0");
  expect_part(why_not(), "CUDA_ERROR_NO_DEVICE");
}

TEST(OpenCudaDevice, WithoutACompiler) {
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda"));
  const Variable nvrtc("RAYWALK_NVRTC", "/no/such/libnvrtc.so.13");
  expect_part(why_not(), "/no/such/libnvrtc.so.13");
}

TEST(OpenCudaDevice, WithEverything) {
  const auto nvrtc = cuda::open_nvrtc();
  if (!nvrtc) GTEST_SKIP() << nvrtc.why_not;
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda"));
  const DeviceOrReason opened = open_cuda_device({});
  ASSERT_NE(opened.device, nullptr) << opened.why_not;
  EXPECT_TRUE(opened.why_not.empty());
  EXPECT_EQ(opened.device->info().details.at("nvrtc"), nvrtc.value->version());
}

}  // namespace
}  // namespace raywalk
