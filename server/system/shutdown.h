// A clean stop on SIGTERM and SIGINT, with a deadline.
#pragma once
#include <functional>
#include <thread>

namespace raywalk {

/// Blocks the signals in this thread and all that it starts; ShutdownWatch takes them.
void block_shutdown_signals();

/// Waits for a signal on a thread of its own and calls `stop`. If the process has not ended after the deadline, or at a
/// second signal, it ends at once.
class ShutdownWatch {
 public:
  explicit ShutdownWatch(std::function<void()> stop);
  ~ShutdownWatch();
  ShutdownWatch(const ShutdownWatch&) = delete;
  ShutdownWatch& operator=(const ShutdownWatch&) = delete;

 private:
  std::thread thread_;
};

}  // namespace raywalk
