// The cache gives back exactly what was stored, or nothing.
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sstream>
#include <thread>

#include "server/device/cuda/cubin_cache.h"
#include "tests/support/folder.h"

namespace raywalk::cuda {
namespace {

namespace fs = std::filesystem;

/// The log of one test, instead of stderr.
class CapturedLog {
 public:
  CapturedLog() : earlier_(spdlog::default_logger()) {
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_)));
  }
  ~CapturedLog() { spdlog::set_default_logger(earlier_); }
  size_t lines_with(const std::string& part) const {
    std::istringstream in(text_.str());
    size_t count = 0;
    for (std::string line; std::getline(in, line);) count += line.find(part) != std::string::npos;
    return count;
  }

 private:
  std::ostringstream text_;
  std::shared_ptr<spdlog::logger> earlier_;
};

/// `size` bytes that differ with `seed`.
Compiled sample(size_t size, u32 seed) {
  Compiled compiled;
  for (size_t i = 0; i < size; ++i) compiled.cubin.push_back(static_cast<char>(i * 31 + seed));
  compiled.entries = {{"closest", seed, 1, 2, 3, 4}, {"occluded", seed + 1, 5, 6, 7, 8}};
  return compiled;
}

void expect_same(const Compiled& a, const Compiled& b) {
  EXPECT_EQ(a.cubin, b.cubin);
  ASSERT_EQ(a.entries.size(), b.entries.size());
  for (size_t i = 0; i < a.entries.size(); ++i) {
    EXPECT_EQ(a.entries[i].entry, b.entries[i].entry);
    EXPECT_EQ(a.entries[i].registers, b.entries[i].registers);
    EXPECT_EQ(a.entries[i].stack_bytes, b.entries[i].stack_bytes);
    EXPECT_EQ(a.entries[i].spill_store_bytes, b.entries[i].spill_store_bytes);
    EXPECT_EQ(a.entries[i].spill_load_bytes, b.entries[i].spill_load_bytes);
    EXPECT_EQ(a.entries[i].shared_bytes, b.entries[i].shared_bytes);
  }
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& contents) {
  std::ofstream(file, std::ios::binary) << contents;
}

TEST(CubinCache, GivesBackWhatWasStored) {
  const test::Folder folder;
  const CubinCache cache(folder.path() / "made" / "when missing");
  EXPECT_FALSE(cache.load("k"));
  cache.store("k", sample(100, 1));
  const std::optional<Compiled> kept = cache.load("k");
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->cached);
  expect_same(*kept, sample(100, 1));
}

TEST(CubinCache, NothingOfADamagedFileIsUsed) {
  const CapturedLog log;
  const test::Folder folder;
  const CubinCache cache(folder.path());
  cache.store("k", sample(40, 1));
  const std::string good = read(cache.file_of("k"));
  for (size_t length = 0; length < good.size(); ++length) {
    write(cache.file_of("k"), good.substr(0, length));
    EXPECT_FALSE(cache.load("k")) << "cut to " << length;
  }
  for (size_t i = 0; i < good.size(); ++i) {
    std::string flipped = good;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << i % 8));
    write(cache.file_of("k"), flipped);
    EXPECT_FALSE(cache.load("k")) << "byte " << i;
  }
  write(cache.file_of("k"), good + "x");
  EXPECT_FALSE(cache.load("k"));
  EXPECT_EQ(log.lines_with("is damaged or of another version"), 2 * good.size() + 1);
  write(cache.file_of("k"), good);
  EXPECT_TRUE(cache.load("k"));
}

TEST(CubinCache, AFileOfAnotherKeyIsNotUsed) {
  const CapturedLog log;
  const test::Folder folder;
  const CubinCache cache(folder.path());
  cache.store("a", sample(40, 1));
  fs::copy_file(cache.file_of("a"), cache.file_of("b"));
  EXPECT_FALSE(cache.load("b"));
  EXPECT_TRUE(cache.load("a"));
}

TEST(CubinCache, AFolderInAnEntrysPlaceIsNoEntry) {
  const test::Folder folder;
  fs::create_directory(folder.path() / "k.kernel");
  const CubinCache cache(folder.path());
  EXPECT_FALSE(cache.load("k"));
  cache.store("k", sample(10, 1));
  EXPECT_FALSE(cache.load("k"));
}

TEST(CubinCache, AFolderThatCannotBeWrittenIsToldOnce) {
  const CapturedLog log;
  const test::Folder folder;
  const CubinCache cache(folder.write("a file", "") / "cache");
  for (int i = 0; i < 3; ++i) {
    cache.store("k", sample(10, 1));
    EXPECT_FALSE(cache.load("k"));
  }
  EXPECT_EQ(log.lines_with("cannot be written"), 1u);
}

TEST(CubinCache, WithoutAFolderNothingIsKept) {
  const CubinCache cache("");
  cache.store("raywalk-test-key", sample(10, 1));
  EXPECT_FALSE(cache.load("raywalk-test-key"));
  EXPECT_FALSE(fs::exists(cache.file_of("raywalk-test-key")));
}

/// Stores and loads one key again and again; false as soon as anything but one writer's whole contents comes back.
bool work_on(const CubinCache& cache, u32 seed) {
  constexpr size_t kSize = 20000;
  for (int round = 0; round < 30; ++round) {
    cache.store("k", sample(kSize, seed));
    const std::optional<Compiled> kept = cache.load("k");
    if (!kept || kept->entries.empty() || kept->cubin != sample(kSize, kept->entries[0].registers).cubin) return false;
  }
  return true;
}

TEST(CubinCache, ThreadsAndProcessesShareAFolder) {
  const test::Folder folder;
  std::vector<pid_t> children;
  for (u32 child = 1; child <= 3; ++child) {
    const pid_t pid = fork();
    ASSERT_GE(pid, 0);
    if (pid == 0) _exit(work_on(CubinCache(folder.path()), child) ? 0 : 1);
    children.push_back(pid);
  }
  const CubinCache cache(folder.path());
  std::vector<char> good(3);
  {
    std::vector<std::jthread> threads;
    for (u32 i = 0; i < 3; ++i) threads.emplace_back([&, i] { good[i] = work_on(cache, 10 + i); });
  }
  EXPECT_EQ(good, std::vector<char>(3, 1));
  for (const pid_t pid : children) {
    int status = -1;
    ASSERT_EQ(waitpid(pid, &status, 0), pid);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1) << "files left over";
}

}  // namespace
}  // namespace raywalk::cuda
