// The fake driver keeps what tests of residency rely on: a budget of memory, and copies that arrive.
#include <gtest/gtest.h>

#include <array>

#include "server/device/cuda/driver_api.h"
#include "tests/gpu/fake_driver.h"
#include "tests/support/environment.h"

namespace raywalk::cuda {
namespace {

TEST(FakeDriver, MemoryHasABudgetAndCopiesArrive) {
  const test::Variable library("RAYWALK_LIBCUDA", test::fake_driver("fake_cuda"));
  const test::Variable budget("FAKE_CUDA_MEMORY_BYTES", "1000");
  const Found<DriverApi> driver = open_driver();
  ASSERT_TRUE(driver) << driver.why_not;
  const DriverApi& api = *driver.value;

  CUdeviceptr first = 0, second = 0;
  ASSERT_EQ(api.cuMemAlloc(&first, 600), CUDA_SUCCESS);
  EXPECT_EQ(api.cuMemAlloc(&second, 401), CUDA_ERROR_OUT_OF_MEMORY);
  EXPECT_EQ(api.cuMemAlloc(&second, 400), CUDA_SUCCESS);
  size_t free_bytes = 1, total_bytes = 0;
  EXPECT_EQ(api.cuMemGetInfo(&free_bytes, &total_bytes), CUDA_SUCCESS);
  EXPECT_EQ(free_bytes, 0u);
  EXPECT_EQ(total_bytes, 1000u);

  const std::array<u8, 4> sent = {1, 2, 3, 4};
  std::array<u8, 4> got{};
  EXPECT_EQ(api.cuMemcpyHtoDAsync(first + 596, sent.data(), 4, nullptr), CUDA_SUCCESS);
  EXPECT_EQ(api.cuMemcpyHtoDAsync(first + 597, sent.data(), 4, nullptr), CUDA_ERROR_INVALID_VALUE);
  EXPECT_EQ(api.cuMemcpyDtoHAsync(got.data(), first + 596, 4, nullptr), CUDA_SUCCESS);
  EXPECT_EQ(got, sent);

  EXPECT_EQ(api.cuMemFree(first), CUDA_SUCCESS);
  EXPECT_EQ(api.cuMemFree(first), CUDA_ERROR_INVALID_VALUE);
  EXPECT_EQ(api.cuMemFree(second), CUDA_SUCCESS);
  EXPECT_EQ(api.cuMemGetInfo(&free_bytes, &total_bytes), CUDA_SUCCESS);
  EXPECT_EQ(free_bytes, 1000u);
}

}  // namespace
}  // namespace raywalk::cuda
