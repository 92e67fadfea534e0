// The assembler's log as NVRTC 13.0 gives it.
#include "server/device/cuda/assembler_log.h"

#include <gtest/gtest.h>

namespace raywalk::cuda {
namespace {

TEST(AssemblerLog, FiguresOfEachEntry) {
  const std::vector<EntryReport> reports = read_assembler_log(
      "kernels/gpu/trace.cu(3): warning #177-D: something\n"
      "ptxas info    : 0 bytes gmem\n"
      "ptxas info    : Compiling entry function 'occluded' for 'sm_90'\n"
      "ptxas info    : Function properties for occluded\n"
      "ptxas         .     96 bytes stack frame, 12 bytes spill stores, 8 bytes spill loads\n"
      "ptxas info    : Used 30 registers, used 0 barriers, 96 bytes cumulative stack size\n"
      "ptxas info    : Compile time = 16.707 ms\n"
      "ptxas info    : Compiling entry function 'closest' for 'sm_90'\n"
      "ptxas info    : Function properties for closest\n"
      "ptxas         .     0 bytes stack frame, 0 bytes spill stores, 0 bytes spill loads\n"
      "ptxas info    : Used 255 registers, used 1 barriers, 1152 bytes smem, 640 bytes cmem[0]\n"
      "ptxas info    : Function properties for helper\n"
      "ptxas         .     32 bytes stack frame, 4 bytes spill stores, 4 bytes spill loads");
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].entry, "closest");
  EXPECT_EQ(reports[0].registers, 255u);
  EXPECT_EQ(reports[0].shared_bytes, 1152u);
  EXPECT_EQ(reports[0].stack_bytes, 0u) << "of a function that it calls";
  EXPECT_EQ(reports[1].entry, "occluded");
  EXPECT_EQ(reports[1].registers, 30u);
  EXPECT_EQ(reports[1].stack_bytes, 96u);
  EXPECT_EQ(reports[1].spill_store_bytes, 12u);
  EXPECT_EQ(reports[1].spill_load_bytes, 8u);
  EXPECT_EQ(reports[1].shared_bytes, 0u);
}

TEST(AssemblerLog, AnotherLogHasNoEntries) {
  EXPECT_TRUE(read_assembler_log("").empty());
  EXPECT_TRUE(read_assembler_log("ptxas info    : Used 30 registers\nnothing\n").empty());
}

}  // namespace
}  // namespace raywalk::cuda
