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

TEST(OpenCudaDevice, WithAGpuThatIsTooOld) {
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda")), capability("FAKE_CUDA_CAPABILITY", "75");
  EXPECT_EQ(why_not(), "The GPU Fake GPU has compute capability 7.5, and 8.0 or higher is needed.");
}

TEST(OpenCudaDevice, WithAGpuThatTheCompilerDoesNotKnow) {
  const auto nvrtc = cuda::open_nvrtc();
  if (!nvrtc) GTEST_SKIP() << nvrtc.why_not;
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda")), capability("FAKE_CUDA_CAPABILITY", "999");
  const std::string reason = why_not();
  expect_part(reason, "has the architecture sm_999, and NVRTC " + nvrtc.value->version());
  expect_part(reason, "sm_90");
}

TEST(OpenCudaDevice, WithACompilerThatIsTooOld) {
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda"));
  const Variable nvrtc("RAYWALK_NVRTC", test::fake_driver("fake_nvrtc"));
  expect_part(why_not(), "libfake_nvrtc.so) is too old: it is 12.1, and 12.4 or newer is needed.");
}

TEST(OpenCudaDevice, WithACompilerThatIsTooNewForTheDriver) {
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda")), version("FAKE_CUDA_VERSION", "12080");
  const Variable nvrtc("RAYWALK_NVRTC", test::fake_driver("fake_nvrtc")), newer("FAKE_NVRTC_VERSION", "13000");
  const std::string reason = why_not();
  expect_part(reason, "is too new for the driver: it is 13.0, and the driver supports CUDA 12.8;");
  expect_part(reason, "pip install \"nvidia-cuda-nvrtc-cu12\"");
}

TEST(OpenCudaDevice, WithTheFirstCompilerThatFits) {
  const auto nvrtc = cuda::open_nvrtc();
  if (!nvrtc) GTEST_SKIP() << nvrtc.why_not;
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda"));
  const Variable several("RAYWALK_NVRTC", test::fake_driver("fake_nvrtc") + ":" + nvrtc.value->library->path());
  const DeviceOrReason opened = open_cuda_device({});
  ASSERT_NE(opened.device, nullptr) << opened.why_not;
  EXPECT_EQ(opened.device->info().details.at("nvrtc"), nvrtc.value->version());
}

TEST(OpenCudaDevice, WithoutSensorsTellsWhy) {
  const auto nvrtc = cuda::open_nvrtc();
  if (!nvrtc) GTEST_SKIP() << nvrtc.why_not;
  const Variable driver("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda"));
  const Variable nvml("RAYWALK_LIBNVML", "/no/such/libnvidia-ml.so");
  const DeviceOrReason opened = open_cuda_device({});
  ASSERT_NE(opened.device, nullptr) << opened.why_not;
  expect_part(opened.device->info().details.at("sensors"), "none (There is no NVML.");
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
