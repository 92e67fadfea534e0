// A clean stop on SIGTERM and SIGINT, with a deadline.
#pragma once
#include <atomic>
#include <functional>
#include <thread>

namespace raywalk {

/// Blocks the signals in this thread and all that it starts; ShutdownWatch takes them.
void block_shutdown_signals();

/// As if a signal came after a second, in which answers are sent; the process ends with `exit_code`, after the deadline
/// at the latest. From any thread.
void shut_down_soon(int exit_code);
/// Of the last shut_down_soon; 0 when nobody called it.
int shutdown_exit_code();

/// Waits for a signal on a thread of its own and calls `stop`, unless it is destroyed before. If the process has not
/// ended after the deadline, or at a second signal, it ends at once.
class ShutdownWatch {
 public:
  explicit ShutdownWatch(std::function<void()> stop);
  ~ShutdownWatch();
  ShutdownWatch(const ShutdownWatch&) = delete;
  ShutdownWatch& operator=(const ShutdownWatch&) = delete;

 private:
  std::atomic<bool> unused_{false};  // no signal came in its life
  std::thread thread_;
};

}  // namespace raywalk
