// Copies on the device: shared, counted, dropped in the order of their last use, brought back.
#include "server/device/cuda/residency.h"

#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <thread>

#include "server/device/device.h"
#include "tests/gpu/driver_log.h"
#include "tests/support/environment.h"

namespace raywalk::cuda {
namespace {

using test::driver_log;

constexpr u64 kMiB = 1u << 20;

std::shared_ptr<const Blob> blob_of(u64 size_bytes, u8 fill) {
  Blob blob(size_bytes);
  std::memset(blob.data(), fill, size_bytes);
  return std::make_shared<const Blob>(std::move(blob));
}

class ResidencyTest : public testing::Test {
 protected:
  void open(u64 limit_bytes, u64 memory_bytes = 1u << 30) {
    residency_.reset();
    context_.reset();
    memory_.emplace("FAKE_CUDA_MEMORY_BYTES", std::to_string(memory_bytes));
    context_ = std::make_shared<const Context>(test::logged_driver(), 0);
    residency_ = std::make_shared<Residency>(context_, std::make_shared<const Stream>(context_), limit_bytes);
  }
  static u64 uploads() { return driver_log().count("cuMemcpyHtoD"); }
  u64 used_bytes() const { return context_->memory().total_bytes - context_->memory().free_bytes; }
  bool lies_there(const std::shared_ptr<Residency::Copy>& copy) {
    const u64 before = uploads();
    residency_->hold(copy);
    return uploads() == before;
  }

  std::optional<test::Variable> memory_;
  std::shared_ptr<const Context> context_;
  std::shared_ptr<Residency> residency_;
};

TEST_F(ResidencyTest, ABlobIsUploadedOnceHoweverManyAskForIt) {
  open(0);
  const auto blob = blob_of(1000, 7);
  const auto a = residency_->copy_of(blob), b = residency_->copy_of(blob);
  EXPECT_EQ(a, b);
  EXPECT_EQ(residency_->allocated_bytes(), 0u);
  const Residency::Held first = residency_->hold(a), second = residency_->hold(b);
  EXPECT_EQ(first.address(), second.address());
  EXPECT_EQ(uploads(), 1u);
  EXPECT_EQ(std::memcmp(reinterpret_cast<const void*>(first.address()), blob->data(), 1000), 0);
  EXPECT_EQ(residency_->allocated_bytes(), 1000u);
  EXPECT_EQ(residency_->resident_bytes(), 1000u);
}

TEST_F(ResidencyTest, AnEmptyBlobHasAnAddressToo) {
  open(0);
  const Residency::Held held = residency_->hold(residency_->copy_of(std::make_shared<const Blob>(Blob(0))));
  EXPECT_NE(held.address(), 0u);
  EXPECT_EQ(uploads(), 0u);
}

TEST_F(ResidencyTest, ACopyEndsWithItsLastPointerOnAnyThread) {
  open(0);
  auto copy = residency_->copy_of(blob_of(kMiB, 1));
  residency_->hold(copy);
  std::thread([&] { copy.reset(); }).join();
  EXPECT_EQ(residency_->allocated_bytes(), 0u);
  EXPECT_EQ(used_bytes(), 0u);
}

TEST_F(ResidencyTest, NothingIsFreedWhileTheDeviceWorks) {
  open(0);
  auto copy = residency_->copy_of(blob_of(kMiB, 1));
  residency_->hold(copy);
  {
    const Residency::Working working(*residency_);
    std::thread([&] { copy.reset(); }).join();
    EXPECT_EQ(driver_log().count("cuMemFree"), 0u);
    EXPECT_EQ(residency_->resident_bytes(), 0u);
  }
  EXPECT_EQ(driver_log().count("cuMemFree"), 1u);
  EXPECT_EQ(residency_->allocated_bytes(), 0u);
}

TEST_F(ResidencyTest, TheLeastRecentlyUsedGoesFirst) {
  for (const bool by_limit : {true, false}) {
    open(by_limit ? 3 * kMiB : 0, by_limit ? 1u << 30 : 3 * kMiB);
    std::vector<std::shared_ptr<Residency::Copy>> copies;
    for (u8 i = 0; i < 4; ++i) copies.push_back(residency_->copy_of(blob_of(kMiB, i)));
    for (u32 i : {0, 1, 2, 0}) residency_->hold(copies[i]);
    residency_->hold(copies[3]);  // takes the place of 1
    EXPECT_EQ(residency_->resident_bytes(), 3 * kMiB);
    for (u32 i : {0, 2, 3}) EXPECT_TRUE(lies_there(copies[i])) << i;
    EXPECT_FALSE(lies_there(copies[1]));
    EXPECT_FALSE(lies_there(copies[0]));  // made way for 1
    EXPECT_EQ(used_bytes(), 3 * kMiB);
  }
}

TEST_F(ResidencyTest, WhatIsHeldStays) {
  open(2 * kMiB);
  const auto a = residency_->copy_of(blob_of(kMiB, 1)), b = residency_->copy_of(blob_of(2 * kMiB, 2));
  {
    const Residency::Held held = residency_->hold(a);
    try {
      residency_->hold(b);
      FAIL() << "it does not fit";
    } catch (const OutOfDeviceMemory& error) {
      EXPECT_EQ(error.needed_bytes(), 3 * kMiB);  // with what is held
      EXPECT_EQ(error.free_bytes(), 2 * kMiB);
      EXPECT_STREQ(error.what(),
                   "The device has not enough memory for this: 3.0 MiB are needed, and 2.0 MiB are free.");
    }
    EXPECT_TRUE(lies_there(a));
  }
  residency_->hold(b);  // and it goes on
  EXPECT_FALSE(lies_there(a));
}

TEST_F(ResidencyTest, WhatCannotFitDropsNothing) {
  open(2 * kMiB);
  const auto a = residency_->copy_of(blob_of(kMiB, 1));
  residency_->hold(a);
  EXPECT_THROW(residency_->hold(residency_->copy_of(blob_of(3 * kMiB, 2))), OutOfDeviceMemory);
  EXPECT_TRUE(lies_there(a));
}

TEST_F(ResidencyTest, WorkingMemoryIsReusedAndMakesWayFirst) {
  open(4 * kMiB);
  const auto a = residency_->copy_of(blob_of(kMiB, 1));
  residency_->hold(a);
  CUdeviceptr first = 0;
  {
    const Residency::Scratch scratch = residency_->scratch(2 * kMiB);
    first = scratch.address();
  }
  EXPECT_EQ(residency_->scratch(kMiB).address(), first);  // the larger one serves
  EXPECT_EQ(residency_->allocated_bytes(), 3 * kMiB);
  EXPECT_EQ(residency_->resident_bytes(), kMiB);
  residency_->hold(residency_->copy_of(blob_of(3 * kMiB, 2)));
  EXPECT_EQ(residency_->allocated_bytes(), kMiB);  // that copy has ended
  EXPECT_TRUE(lies_there(a));
}

TEST_F(ResidencyTest, WorkingMemoryInUseIsNotTakenTwice) {
  open(0);
  const Residency::Scratch a = residency_->scratch(100), b = residency_->scratch(100);
  EXPECT_NE(a.address(), b.address());
}

TEST_F(ResidencyTest, AThousandCyclesLeaveNothingBehind) {
  open(8 * kMiB);
  const auto kept = residency_->copy_of(blob_of(kMiB, 1));
  for (u32 i = 0; i < 1000; ++i) {
    const auto copy = residency_->copy_of(blob_of(kMiB + i * 1000, static_cast<u8>(i)));
    const Residency::Held held = residency_->hold(copy);
    const Residency::Held other = residency_->hold(kept);
    const Residency::Scratch scratch = residency_->scratch(1000 + i % 7 * kMiB / 2);
    ASSERT_LE(used_bytes(), 8 * kMiB);
    ASSERT_EQ(used_bytes(), residency_->allocated_bytes());
  }
  residency_->drop_all();
  EXPECT_EQ(residency_->allocated_bytes(), 0u);
  EXPECT_EQ(used_bytes(), 0u);
}

}  // namespace
}  // namespace raywalk::cuda
