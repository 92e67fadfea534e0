// How a driver that is missing, incomplete, too old or without a device is told, and how failed calls are.
#include <gtest/gtest.h>

#include "server/device/cuda/driver_api.h"
#include "server/device/cuda/error.h"
#include "server/device/cuda/nvml_api.h"
#include "tests/gpu/fake_driver.h"
#include "tests/support/environment.h"

namespace raywalk::cuda {
namespace {

using test::fake_driver;
using test::Variable;

void expect_reason(const std::string& reason, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(reason.find(part), std::string::npos) << part << " in: " << reason;
}

TEST(Driver, OpensAndStarts) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda"));
  const Found<DriverApi> driver = open_driver();
  ASSERT_TRUE(driver) << driver.why_not;
  EXPECT_EQ(driver.value->version, 13000);
  EXPECT_EQ(version_text(driver.value->version), "13.0");
  int count = 0;
  RW_CUDA(*driver.value, cuDeviceGetCount, &count);
  EXPECT_EQ(count, 1);
}

TEST(Driver, MissingLibraryIsNamed) {
  const Variable library("RAYWALK_LIBCUDA", "/no/such/libcuda.so");
  const Found<DriverApi> driver = open_driver();
  ASSERT_FALSE(driver);
  expect_reason(driver.why_not, {"There is no NVIDIA driver", "/no/such/libcuda.so", "No such file"});
}

TEST(Driver, MissingSymbolIsNamed) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda_incomplete"));
  const Found<DriverApi> driver = open_driver();
  ASSERT_FALSE(driver);
  expect_reason(driver.why_not, {"libfake_cuda_incomplete.so", "lacks cuLaunchKernel."});
}

TEST(Driver, OldDriverTellsBothVersions) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda"));
  const Variable version("FAKE_CUDA_VERSION", "11080");
  const Found<DriverApi> driver = open_driver();
  ASSERT_FALSE(driver);
  expect_reason(driver.why_not, {"too old", "supports CUDA 11.8", "CUDA 12.0 or newer is needed"});
}

TEST(Driver, AgeIsTheReasonWhenSymbolsAreMissingToo) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda_incomplete"));
  const Variable version("FAKE_CUDA_VERSION", "11080");
  expect_reason(open_driver().why_not, {"too old"});
}

TEST(Driver, NoDeviceIsAReason) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda"));
  const Variable devices("FAKE_CUDA_DEVICES", "0");
  const Found<DriverApi> driver = open_driver();
  ASSERT_FALSE(driver);
  expect_reason(driver.why_not, {"does not start", "cuInit: CUDA_ERROR_NO_DEVICE"});
}

TEST(Driver, FailedCallTellsCallErrorAndPlace) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda"));
  const Found<DriverApi> driver = open_driver();
  ASSERT_TRUE(driver) << driver.why_not;
  CUdeviceptr memory = 0;
  try {
    RW_CUDA(*driver.value, cuMemAlloc, &memory, size_t{1} << 40);
    FAIL() << "no exception";
  } catch (const CudaError& e) {
    EXPECT_EQ(e.code(), CUDA_ERROR_OUT_OF_MEMORY);
    EXPECT_FALSE(e.context_is_lost());
    expect_reason(e.what(), {"cuMemAlloc: CUDA_ERROR_OUT_OF_MEMORY (", "driver_test.cpp:"});
  }
}

TEST(Driver, UnknownErrorHasItsNumber) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda"));
  const Found<DriverApi> driver = open_driver();
  ASSERT_TRUE(driver) << driver.why_not;
  EXPECT_EQ(describe(*driver.value, static_cast<CUresult>(4711)), "error 4711");
}

TEST(Driver, FailedLaunchLosesTheContext) {
  const Variable library("RAYWALK_LIBCUDA", fake_driver("fake_cuda"));
  const Variable fail("FAKE_CUDA_FAIL_LAUNCH", "2");
  const Found<DriverApi> driver = open_driver();
  ASSERT_TRUE(driver) << driver.why_not;
  const DriverApi& api = *driver.value;
  const auto launch = [&] { RW_CUDA(api, cuLaunchKernel, nullptr, 1, 1, 1, 32, 1, 1, 0, nullptr, nullptr, nullptr); };
  launch();
  EXPECT_THROW(launch(), CudaError);
  try {
    RW_CUDA(api, cuStreamSynchronize, nullptr);
    FAIL() << "the context is lost";
  } catch (const CudaError& e) {
    EXPECT_TRUE(e.context_is_lost());
  }
}

TEST(Library, HasTheIdentityOfItsBuild) {
  const auto identity = [](const std::string& name) {
    const std::string path = fake_driver(name);
    const Found<Library> library = Library::open({&path, 1});
    return library ? library.value->identity() : library.why_not;
  };
  EXPECT_EQ(identity("fake_cuda"), identity("fake_cuda"));
  EXPECT_NE(identity("fake_cuda"), identity("fake_cuda_incomplete"));
  EXPECT_TRUE(identity("fake_cuda").starts_with("libfake_cuda.so ")) << identity("fake_cuda");
}

TEST(Nvml, MissingLibraryAndSymbolsAreNamed) {
  {
    const Variable library("RAYWALK_LIBNVML", "/no/such/libnvidia-ml.so");
    expect_reason(open_nvml().why_not, {"There is no NVML", "/no/such/libnvidia-ml.so"});
  }
  const Variable library("RAYWALK_LIBNVML", fake_driver("fake_cuda"));
  expect_reason(open_nvml().why_not, {"lacks nvmlInit_v2", "nvmlErrorString"});
}

}  // namespace
}  // namespace raywalk::cuda
