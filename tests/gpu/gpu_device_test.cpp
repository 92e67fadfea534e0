// A real GPU as a device: memory that comes back, batches, figures, sensors, and a kernel that fails.
#include <algorithm>

#include "tests/gpu/gpu.h"
#include "tests/support/frame_jobs.h"
#include "tests/support/small_scenes.h"

namespace raywalk {
namespace {

using test::room_job;
using test::SceneBlob;

constexpr u64 kMiB = 1u << 20;

class GpuDevice : public test::GpuTest {};

SceneBlob sphere(u32 level) {
  return std::make_shared<const Blob>(test::make_scene(test::icosphere(level)));
}
SceneBlob soup(u32 triangles) {
  return std::make_shared<const Blob>(test::make_scene(test::random_soup(3, triangles, 0.02f)));
}

FrameJob sphere_job(Device& device, u32 side) {
  FrameJob job = room_job(device.build(sphere(5), "bvh", {}), "while-while", Mode::primary);
  job.camera = {{0, 0, 3}, {0, 0, 0}, {0, 1, 0}, 45};
  job.width = job.height = side;
  return job;
}

TEST_F(GpuDevice, AThousandCyclesTakeNoMemory) {
  Frame frame;
  const auto cycle = [&](u32 i) {
    FrameJob job = room_job(gpu().build(sphere(2 + i % 3), i % 2 == 0 ? "bvh" : "grid", {}),
                            i % 2 == 0 ? "while-while" : "dda", Mode::primary);
    gpu().render(job, frame);
  };
  for (u32 i = 0; i < 12; ++i) cycle(i);  // every kernel, every size
  const DeviceMemory before = gpu().memory();
  for (u32 i = 0; i < 1000; ++i) cycle(i);
  const DeviceMemory after = gpu().memory();
  EXPECT_EQ(after.resident_bytes, before.resident_bytes);
  EXPECT_GE(after.free_bytes + 2 * kMiB, before.free_bytes);  // the driver hands memory out in pieces of that size
}

TEST_F(GpuDevice, OutOfMemoryIsToldAndTheDeviceGoesOn) {
  CudaConfig config;
  config.memory_limit_bytes = 16 * kMiB;
  const auto small = test::open_gpu(config);
  ASSERT_NE(small.device, nullptr) << small.why_not;
  try {
    small.device->build(soup(300'000), "bvh", {});
    FAIL() << "it does not fit";
  } catch (const OutOfDeviceMemory& error) {
    EXPECT_GT(error.needed_bytes(), error.free_bytes());
    EXPECT_LE(error.free_bytes(), 16 * kMiB);
  }
  // Three that do not fit together take turns.
  std::vector<FrameJob> jobs;
  for (int i = 0; i < 3; ++i)
    jobs.push_back(room_job(small.device->build(soup(60'000), "bvh", {}), "while-while", Mode::primary));
  std::vector<float> expected;
  for (int turn = 0; turn < 2; ++turn) {
    for (const FrameJob& job : jobs) {
      Frame frame;
      small.device->render(job, frame);
      if (expected.empty()) expected = frame.pixels;
      EXPECT_EQ(frame.pixels, expected);
    }
  }
  EXPECT_LE(small.device->memory().resident_bytes, 16 * kMiB);
}

TEST_F(GpuDevice, ABatchTakesLongerThanAFrameAndLessThanItsFramesAlone) {
  const FrameJob job = sphere_job(gpu(), 512);
  const std::vector<FrameJob> batch(16, job);
  for (const Work work : {Work::trace, Work::frame}) {
    const auto best = [&](std::span<const FrameJob> jobs) {
      double least_ms = 1e9;
      for (int i = 0; i < 20; ++i) least_ms = std::min(least_ms, gpu().measure(jobs, work));
      return least_ms;
    };
    const double one_ms = best({&job, 1}), all_ms = best(batch);
    EXPECT_GT(one_ms, 0.0);
    EXPECT_GT(all_ms, one_ms);
    EXPECT_LT(all_ms, 16 * one_ms);
  }
}

TEST_F(GpuDevice, FiguresAreThoseOfTheKernel) {
  FrameJob job = sphere_job(gpu(), 64);
  for (const Work work : {Work::trace, Work::frame}) {
    job.kernel = {};
    const KernelFigures free = gpu().kernel_figures(job, work).value();
    EXPECT_GE(free.registers, 16u);
    EXPECT_LE(free.registers, 255u);
    EXPECT_GT(free.blocks_per_multiprocessor, 0u);
    EXPECT_GT(free.occupancy, 0.0);
    EXPECT_LE(free.occupancy, 1.0);
    EXPECT_GT(free.binary_bytes, 1000u);
    job.kernel = {{"registers", 32}, {"block", 256}};
    const KernelFigures capped = gpu().kernel_figures(job, work).value();
    EXPECT_LE(capped.registers, 32u);
    EXPECT_EQ(capped.threads_per_block, 256u);
    EXPECT_GE(capped.occupancy, free.occupancy);
  }
}

TEST_F(GpuDevice, SensorsReadSomethingPlausible) {
  const auto now = gpu().telemetry();
  if (!now) GTEST_SKIP() << "NVML cannot be opened, or does not know the GPU";
  EXPECT_GT(now->core_clock_mhz, 100u);
  EXPECT_GT(now->power_w, 5.0);
  EXPECT_GE(now->power_limit_w, now->power_w * 0.5);
  EXPECT_GT(now->temperature_c, 10u);
  EXPECT_LT(now->temperature_c, 110u);
}

/// In a process of its own: the failure takes the context with it.
[[noreturn]] void render_until_it_fails() {
  CudaConfig config;
  config.fault_after = 5;
  const auto opened = test::open_gpu(config);
  if (!opened.device) std::exit(2);
  const FrameJob job = sphere_job(*opened.device, 64);
  Frame frame;
  for (int i = 0; i < 10; ++i) {
    try {
      opened.device->render(job, frame);
    } catch (const DeviceLost& first) {
      try {
        opened.device->render(job, frame);
      } catch (const DeviceLost& second) {
        std::fprintf(stderr, "%s\n", second.what());
        std::exit(i == 3 && std::string(first.what()) == second.what() ? 0 : 3);
      }
    }
  }
  std::exit(4);
}

TEST_F(GpuDevice, AKernelThatFailsTakesTheDeviceWithIt) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(render_until_it_fails(), testing::ExitedWithCode(0), "CUDA_ERROR_LAUNCH_FAILED");
}

}  // namespace
}  // namespace raywalk
