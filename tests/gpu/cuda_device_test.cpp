// The CUDA device on the fake driver: what it launches and when, and what follows when something fails.
#include "server/device/cuda/cuda_device.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/gpu/driver_log.h"
#include "tests/support/environment.h"
#include "tests/support/frame_jobs.h"
#include "tests/support/small_scenes.h"

namespace raywalk::cuda {
namespace {

using test::driver_log;
using test::room_job;
using test::SceneBlob;

constexpr u64 kMiB = 1u << 20;

class CudaDeviceTest : public testing::Test {
 protected:
  void open(CudaConfig config = {}) {
    config.threads = 1;
    device_.reset();
    const auto context = std::make_shared<const Context>(test::logged_driver(), 0);
    const auto compiler = std::make_shared<const Compiler>(test::logged_compiler(), context->facts().architecture, "");
    device_ = std::make_unique<CudaDevice>(context, compiler, std::map<std::string, std::string>{}, config);
  }
  static SceneBlob room() { return std::make_shared<const Blob>(test::room({})); }
  static SceneBlob soup(u32 triangles) {
    return std::make_shared<const Blob>(test::make_scene(test::random_soup(3, triangles)));
  }
  FrameJob job(Mode mode = Mode::whitted) { return room_job(device_->build(room(), "bvh", {}), "while-while", mode); }
  /// Calls since the log was cleared, from one event to the next.
  static std::vector<std::string> between_events() {
    const auto& calls = driver_log().calls;
    const auto first = std::find(calls.begin(), calls.end(), "cuEventRecord");
    if (first == calls.end()) return {};
    return {first + 1, std::find(first + 1, calls.end(), "cuEventRecord")};
  }

  std::unique_ptr<CudaDevice> device_;
};

TEST_F(CudaDeviceTest, TellsWhatItIs) {
  open();
  EXPECT_EQ(device_->info().kind, "cuda");
  EXPECT_EQ(device_->info().name, "Fake GPU");
  EXPECT_EQ(device_->info().details.at("architecture"), "sm_90");
  EXPECT_EQ(device_->info().details.at("multiprocessors"), "132");
  EXPECT_NE(device_->info().details.at("driver").find("CUDA 13.0"), std::string::npos);
  EXPECT_EQ(device_->max_batch(), 16u);
  for (const KindInfo& kind : device_->kinds()) {
    EXPECT_FALSE(kind.traversals.empty()) << kind.name;
    for (const TraversalInfo& traversal : kind.traversals) EXPECT_FALSE(traversal.options.empty()) << traversal.name;
  }
}

TEST_F(CudaDeviceTest, NothingButTheKernelIsTimed) {
  open();
  const std::vector<FrameJob> jobs(16, job());
  for (const auto& [work, kernel] : {std::pair{Work::frame, "frame"}, std::pair{Work::trace, "closest"}}) {
    for (int use = 0; use < 2; ++use) {
      driver_log() = {};
      EXPECT_GE(device_->measure(jobs, work), 0.0);
      EXPECT_EQ(between_events(), std::vector<std::string>{kernel}) << use;
      EXPECT_EQ(driver_log().count("cuMemcpyDtoH"), 0u);
      if (use == 0) continue;
      EXPECT_EQ(driver_log().count("cuMemAlloc"), 0u);
      EXPECT_EQ(driver_log().count("cuMemcpyHtoD"), 0u);
      EXPECT_EQ(driver_log().count("nvrtcCompileProgram"), 0u);
    }
  }
}

TEST_F(CudaDeviceTest, ABatchIsOfOneKind) {
  open();
  std::vector<FrameJob> jobs(17, job());
  EXPECT_THROW(device_->measure(jobs, Work::frame), std::invalid_argument);
  EXPECT_THROW(device_->measure({}, Work::frame), std::invalid_argument);
  jobs.resize(2);
  jobs[1].camera.eye.x += 0.1f;
  EXPECT_NO_THROW(device_->measure(jobs, Work::frame));
  jobs[1].width += 1;
  EXPECT_THROW(device_->measure(jobs, Work::frame), std::invalid_argument);
}

TEST_F(CudaDeviceTest, FiguresAreOfTheKernelThatIsMeasured) {
  open();
  FrameJob asked = job();
  asked.kernel = {{"block", 256}};
  const KernelFigures figures = device_->kernel_figures(asked, Work::trace).value();
  EXPECT_EQ(figures.registers, 40u);
  EXPECT_EQ(figures.threads_per_block, 256u);
  EXPECT_EQ(figures.blocks_per_multiprocessor, 4u);
  EXPECT_DOUBLE_EQ(figures.occupancy, 0.5);
  EXPECT_GT(figures.binary_bytes, 0u);
  driver_log() = {};
  device_->measure({&asked, 1}, Work::trace);
  EXPECT_EQ(driver_log().count("nvrtcCompileProgram"), 0u);
}

TEST_F(CudaDeviceTest, ALongListOfRaysIsCutUp) {
  open();
  const auto structure = device_->build(room(), "bvh", {});
  const std::vector<Ray> rays((1u << 22) + 1);
  driver_log() = {};
  EXPECT_EQ(device_->occluded({structure, "while-while", rays}).size(), rays.size());
  EXPECT_EQ(driver_log().count("occluded"), 2u);
  EXPECT_TRUE(device_->closest({structure, "while-while", {}}).empty());
}

TEST_F(CudaDeviceTest, LostInMidJobIsLostForGood) {
  const test::Variable third("FAKE_CUDA_FAIL_LAUNCH", "3");
  open();
  const FrameJob asked = job();
  Frame frame;
  device_->render(asked, frame);  // two launches: a kernel's first use is not timed
  try {
    device_->render(asked, frame);
    FAIL() << "the third launch fails";
  } catch (const DeviceLost& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("cuLaunchKernel: CUDA_ERROR_LAUNCH_FAILED"), std::string::npos) << what;
    EXPECT_NE(what.find("server/device/cuda/launch.cpp:"), std::string::npos) << what;
  }
  driver_log() = {};
  EXPECT_THROW(device_->build(room(), "bvh", {}), DeviceLost);
  EXPECT_THROW(device_->render(asked, frame), DeviceLost);
  EXPECT_THROW(device_->measure({&asked, 1}, Work::trace), DeviceLost);
  EXPECT_THROW(device_->count(asked), DeviceLost);
  EXPECT_TRUE(driver_log().calls.empty());
  EXPECT_EQ(device_->memory().free_bytes, 0u);
}

TEST_F(CudaDeviceTest, TheKernelThatFailsIsTheOneAskedFor) {
  CudaConfig config;
  config.fault_after = 3;
  open(config);
  const FrameJob asked = job();
  Frame frame;
  device_->render(asked, frame);
  EXPECT_EQ(driver_log().count("fault"), 0u);
  device_->render(asked, frame);
  EXPECT_EQ(driver_log().count("fault"), 1u);
  device_->render(asked, frame);  // the fake has survived it
  EXPECT_EQ(driver_log().count("fault"), 1u);
  EXPECT_EQ(driver_log().count("frame"), 3u);
}

TEST_F(CudaDeviceTest, OutOfMemoryIsToldAndTheDeviceGoesOn) {
  CudaConfig config;
  config.memory_limit_bytes = 4 * kMiB;
  open(config);
  try {
    device_->build(soup(100'000), "bvh", {});
    FAIL() << "it does not fit";
  } catch (const OutOfDeviceMemory& error) {
    EXPECT_GT(error.needed_bytes(), 6 * kMiB);
    EXPECT_EQ(error.free_bytes(), 4 * kMiB);
  }
  EXPECT_EQ(device_->memory().resident_bytes, 0u);
  FrameJob asked = job();
  Frame frame;
  device_->render(asked, frame);
  asked.width = asked.height = 1024;
  EXPECT_THROW(device_->render(asked, frame), OutOfDeviceMemory);
  asked.width = asked.height = 64;
  device_->render(asked, frame);
  EXPECT_EQ(frame.pixels.size(), 64u * 64u * 3u);
}

TEST_F(CudaDeviceTest, WhatALaunchNeedsIsToldAltogether) {
  const test::Variable memory("FAKE_CUDA_MEMORY_BYTES", std::to_string(64 * kMiB));
  open();
  FrameJob asked = job();
  asked.width = asked.height = 512;
  const std::vector<FrameJob> jobs(8, asked);
  const u64 held = device_->memory().resident_bytes;
  ASSERT_GT(held, 0u);
  try {
    device_->measure(jobs, Work::trace);
    FAIL() << "it does not fit";
  } catch (const OutOfDeviceMemory& error) {
    EXPECT_EQ(error.needed_bytes(), held + 8 * 512 * 512 * (sizeof(Hit) + sizeof(Ray)));
    EXPECT_EQ(error.free_bytes(), 64 * kMiB);
  }
  EXPECT_EQ(device_->memory().resident_bytes, held) << "a launch drops what it reads";
}

TEST_F(CudaDeviceTest, WhatWasDroppedComesBack) {
  CudaConfig config;
  config.memory_limit_bytes = 3 * kMiB;
  open(config);
  Frame frame;
  std::vector<FrameJob> jobs;
  for (int i = 0; i < 3; ++i)
    jobs.push_back(room_job(device_->build(soup(12'000), "bvh", {}), "while-while", Mode::primary));
  EXPECT_LE(device_->memory().resident_bytes, 3 * kMiB);
  for (int turn = 0; turn < 3; ++turn) {
    for (const FrameJob& asked : jobs) {
      driver_log() = {};
      device_->render(asked, frame);
      EXPECT_EQ(driver_log().count("cuMemcpyHtoD"), 2u);  // scene and structure
    }
  }
  driver_log() = {};
  device_->render(jobs.back(), frame);
  EXPECT_EQ(driver_log().count("cuMemcpyHtoD"), 0u);
}

TEST_F(CudaDeviceTest, StructuresMayOutliveTheDevice) {
  open();
  const auto structure = device_->build(room(), "kdtree", {});
  EXPECT_GT(device_->memory().resident_bytes, 0u);
  device_.reset();
  EXPECT_EQ(structure->kind(), "kdtree");
}

}  // namespace
}  // namespace raywalk::cuda
