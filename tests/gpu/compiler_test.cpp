// Kernels compiled by NVRTC, without a device. Skipped where there is no NVRTC.
#include "server/device/cuda/compiler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "server/device/cuda/kernel_listing.h"
#include "server/device/cuda/nvrtc_api.h"
#include "tests/support/environment.h"
#include "tests/support/folder.h"

namespace raywalk::cuda {
namespace {

namespace fs = std::filesystem;

KernelSpec small_kernel() {
  return {.program = Program::trace, .traversal = "Brute", .features = 0};
}

class WithNvrtc : public testing::Test {
 protected:
  void SetUp() override {
    static const Found<NvrtcApi> found = open_nvrtc();
    if (!found) GTEST_SKIP() << found.why_not;
    nvrtc_ = found.value;
  }
  Compiled compile(const KernelSpec& spec, const fs::path& cache = {}) const {
    return Compiler(nvrtc_, "sm_90", cache).compile(spec);
  }

  std::shared_ptr<const NvrtcApi> nvrtc_;
};

using CompilerTest = WithNvrtc;

TEST_F(CompilerTest, MachineCodeAndReportOfEachEntry) {
  const Compiled compiled = compile(small_kernel());
  ASSERT_GT(compiled.cubin.size(), 4u);
  EXPECT_EQ(std::string_view(compiled.cubin.data(), 4),
            "\x7f"
            "ELF");
  EXPECT_FALSE(compiled.cached);
  ASSERT_EQ(compiled.entries.size(), 3u);
  EXPECT_EQ(compiled.entries[0].entry, "closest");
  EXPECT_EQ(compiled.entries[1].entry, "occluded");
  EXPECT_EQ(compiled.entries[2].entry, "primary_rays");
  for (const EntryReport& report : compiled.entries) EXPECT_GT(report.registers, 0u) << report.entry;
}

TEST_F(CompilerTest, TheSameKernelIsTheSameBytes) {
  EXPECT_EQ(compile(small_kernel()).cubin, compile(small_kernel()).cubin);
}

TEST_F(CompilerTest, ACapBoundsTheRegisters) {
  KernelSpec spec = small_kernel();
  const u32 free_choice = compile(spec).entries[0].registers;
  ASSERT_GT(free_choice, 32u);
  spec.registers = 32;
  EXPECT_LE(compile(spec).entries[0].registers, 32u);
}

TEST_F(CompilerTest, TheCacheGivesTheSameBytes) {
  const test::Folder folder;
  const Compiled first = compile(small_kernel(), folder.path());
  const Compiled second = compile(small_kernel(), folder.path());
  EXPECT_FALSE(first.cached);
  EXPECT_TRUE(second.cached);
  EXPECT_EQ(first.cubin, second.cubin);
  ASSERT_EQ(second.entries.size(), first.entries.size());
  EXPECT_EQ(second.entries[0].registers, first.entries[0].registers);
}

TEST_F(CompilerTest, OtherOptionsAreOtherKernels) {
  const test::Folder folder;
  KernelSpec spec = small_kernel();
  compile(spec, folder.path());
  spec.block = 64;
  EXPECT_FALSE(compile(spec, folder.path()).cached);
  EXPECT_FALSE(Compiler(nvrtc_, "sm_80", folder.path()).compile(spec).cached);
}

TEST_F(CompilerTest, AnotherBuildOfTheCompilerIsAnotherKernel) {
  EXPECT_NE(nvrtc_->identity.find("libnvrtc.so."), std::string::npos) << nvrtc_->identity;
  const test::Folder folder;
  compile(small_kernel(), folder.path());
  const auto patched = std::make_shared<NvrtcApi>(*nvrtc_);
  patched->identity += '0';
  EXPECT_FALSE(Compiler(patched, "sm_90", folder.path()).compile(small_kernel()).cached);
  EXPECT_TRUE(compile(small_kernel(), folder.path()).cached);
}

TEST_F(CompilerTest, ADamagedFileIsReplaced) {
  const test::Folder folder;
  const Compiled first = compile(small_kernel(), folder.path());
  const fs::path file = fs::directory_iterator(folder.path())->path();
  fs::resize_file(file, fs::file_size(file) / 2);
  const Compiled again = compile(small_kernel(), folder.path());
  EXPECT_FALSE(again.cached);
  EXPECT_EQ(again.cubin, first.cubin);
  EXPECT_TRUE(compile(small_kernel(), folder.path()).cached);
}

TEST_F(CompilerTest, TwoDaemonsStartOnOneFolder) {
  const test::Folder folder;
  Compiled results[2];
  {
    std::vector<std::jthread> threads;
    for (Compiled& result : results) threads.emplace_back([&] { result = compile(small_kernel(), folder.path()); });
  }
  EXPECT_EQ(results[0].cubin, results[1].cubin);
  EXPECT_TRUE(compile(small_kernel(), folder.path()).cached);
}

TEST_F(CompilerTest, AnErrorCarriesTheLog) {
  KernelSpec spec = small_kernel();
  spec.traversal = "NoSuchTraversal";
  try {
    compile(spec);
    FAIL() << "no exception";
  } catch (const CompileError& e) {
    const std::string what = e.what();
    for (const char* part : {"trace NoSuchTraversal", "sm_90", "NVRTC_ERROR_COMPILATION", "kernels/gpu/trace.cu(",
                             "identifier \"NoSuchTraversal\" is undefined"}) {
      EXPECT_NE(what.find(part), std::string::npos) << part << " in: " << what;
    }
  }
}

TEST_F(CompilerTest, AnUnknownArchitectureNamesThoseThatAreKnown) {
  try {
    list_kernels(nvrtc_, {"sm_90", "sm_12345"});
    FAIL() << "no exception";
  } catch (const UnknownArchitecture& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("'sm_12345'"), std::string::npos) << what;
    EXPECT_NE(what.find("sm_90"), std::string::npos) << what;
  }
}

TEST(Nvrtc, ABadPathIsTheReason) {
  const test::Variable library("RAYWALK_NVRTC", "/no/such/libnvrtc.so");
  const Found<NvrtcApi> nvrtc = open_nvrtc();
  ASSERT_FALSE(nvrtc);
  EXPECT_NE(nvrtc.why_not.find("There is no kernel compiler (NVRTC)"), std::string::npos) << nvrtc.why_not;
  EXPECT_NE(nvrtc.why_not.find("/no/such/libnvrtc.so"), std::string::npos) << nvrtc.why_not;
}

TEST(Nvrtc, AnotherLibraryLacksItsCalls) {
  const test::Variable library("RAYWALK_NVRTC", "libm.so.6");
  const Found<NvrtcApi> nvrtc = open_nvrtc();
  ASSERT_FALSE(nvrtc);
  EXPECT_NE(nvrtc.why_not.find("lacks nvrtcVersion"), std::string::npos) << nvrtc.why_not;
}

TEST(Nvrtc, IsLookedForInThePythonEnvironmentAfterTheLoader) {
  const test::Folder folder;
  const fs::path library = folder.write("lib/python3.11/site-packages/nvidia/cu13/lib/libnvrtc.so.13", "");
  const test::Variable environment("VIRTUAL_ENV", folder.path());
  const test::Variable none("RAYWALK_NVRTC", "");
  const std::vector<std::string> places = nvrtc_places();
  EXPECT_EQ(places.front(), "libnvrtc.so.13");
  EXPECT_TRUE(std::ranges::find(places, library.string()) != places.end());
}

}  // namespace
}  // namespace raywalk::cuda
