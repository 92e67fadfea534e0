// Ten million triangles: generated in memory that does not grow, loaded within three times the arrays.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>

#include "scenes/generator.h"
#include "server/scene/importer.h"
#include "server/scene/sinks.h"
#include "tests/scene/files.h"

namespace raywalk {
namespace {

constexpr u64 kTriangles = 10'000'000;

/// Largest resident size of this process so far.
u64 peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
  return 0;
}

/// Runs `work` in a child of its own and returns by how much its peak rose; 0 when it failed.
u64 peak_of(const std::function<bool()>& work) {
  int ends[2];
  if (pipe(ends) != 0) return 0;
  const pid_t child = fork();
  if (child == 0) {
    const u64 before = peak_bytes();
    const u64 rise = work() ? peak_bytes() - before : 0;
    _exit(write(ends[1], &rise, sizeof rise) == sizeof rise ? 0 : 1);
  }
  close(ends[1]);
  u64 rise = 0;
  if (read(ends[0], &rise, sizeof rise) != sizeof rise) rise = 0;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return rise;
}

TEST(MemorySlow, TenMillionTriangles) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer's own memory is not what is measured here";
#endif
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "soup.ply";
  const u64 generating = peak_of([&] {
    PlySink sink(file);
    generate(*find_generator("soup"), kTriangles, sink);
    sink.finish();
    return true;
  });
  ASSERT_GT(generating, 0u);
  EXPECT_LT(generating, u64{64} << 20) << "a generator's memory grows with the mesh";

  const u64 arrays = kTriangles * (6 * sizeof(Vec3) + sizeof(TriangleIndices));  // no triangle shares its vertices
  const u64 loading = peak_of([&] {
    const Scene scene = load_mesh(file);
    return scene.triangles.size() == kTriangles;
  });
  ASSERT_GT(loading, 0u) << "loading failed";
  EXPECT_LT(loading, 3 * arrays);
  std::cout << "generating: " << (generating >> 20) << " MiB, loading: " << (loading >> 20) << " MiB for arrays of "
            << (arrays >> 20) << " MiB\n";
}

}  // namespace
}  // namespace raywalk
