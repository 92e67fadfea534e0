// Signals are taken by sigwait, not by a handler: any code may run.
#include "server/system/shutdown.h"

#include <pthread.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <csignal>

namespace raywalk {
namespace {

constexpr time_t kDeadlineSeconds = 8;

sigset_t shutdown_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGINT);
  return set;
}

/// The daemon keeps nothing that an abrupt end could harm.
void end_at_deadline() {
  const sigset_t set = shutdown_signals();
  const timespec deadline{kDeadlineSeconds, 0};
  sigtimedwait(&set, nullptr, &deadline);
  spdlog::warn("work did not end in time; leaving it");
  _exit(0);
}

}  // namespace

void block_shutdown_signals() {
  const sigset_t set = shutdown_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

ShutdownWatch::ShutdownWatch(std::function<void()> stop)
    : thread_([stop = std::move(stop)] {
        const sigset_t set = shutdown_signals();
        int signal = 0;
        sigwait(&set, &signal);
        spdlog::info("stopping: signal {}", signal);
        std::thread(end_at_deadline).detach();
        stop();
      }) {}

ShutdownWatch::~ShutdownWatch() {
  if (!thread_.joinable()) return;
  pthread_kill(thread_.native_handle(), SIGTERM);  // wakes it when the server ended by itself
  thread_.join();
}

}  // namespace raywalk
