// Ending by itself: through the same stop as a signal, with its own exit code.
#include "server/system/shutdown.h"

#include <gtest/gtest.h>

#include <future>

namespace raywalk {
namespace {

void end_with(int exit_code) {
  block_shutdown_signals();
  std::promise<void> stopped;
  shut_down_soon(exit_code);
  const ShutdownWatch watch([&] { stopped.set_value(); });
  stopped.get_future().wait();
  std::_Exit(shutdown_exit_code());
}

TEST(Shutdown, SoonIsAStopWithAnExitCode) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(end_with(5), testing::ExitedWithCode(5), "");
}

}  // namespace
}  // namespace raywalk
