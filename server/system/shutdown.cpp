// Signals are taken by sigwait, not by a handler: any code may run.
#include "server/system/shutdown.h"

#include <pthread.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace raywalk {
namespace {

constexpr time_t kDeadlineSeconds = 8;
constexpr std::chrono::milliseconds kRepeats{500};  // one stop may send several signals
constexpr std::chrono::seconds kSoon{1};

std::atomic<int> exit_code_of_process{0};

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
  std::this_thread::sleep_for(kRepeats);
  const timespec now{0, 0}, deadline{kDeadlineSeconds, 0};
  while (sigtimedwait(&set, nullptr, &now) > 0) {
  }
  const bool signalled = sigtimedwait(&set, nullptr, &deadline) > 0;
  spdlog::warn(signalled ? "another signal; leaving unfinished work" : "work did not end in time; leaving it");
  _exit(exit_code_of_process);
}

}  // namespace

void block_shutdown_signals() {
  const sigset_t set = shutdown_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

void shut_down_soon(int exit_code) {
  exit_code_of_process = exit_code;
  std::thread([] {
    std::this_thread::sleep_for(kSoon);
    kill(getpid(), SIGTERM);
  }).detach();
}

int shutdown_exit_code() {
  return exit_code_of_process;
}

ShutdownWatch::ShutdownWatch(std::function<void()> stop)
    : thread_([this, stop = std::move(stop)] {
        const sigset_t set = shutdown_signals();
        int signal = 0;
        sigwait(&set, &signal);
        if (unused_) return;
        if (exit_code_of_process == 0) {
          spdlog::info("stopping: signal {}", signal);
        } else {
          spdlog::info("stopping, with exit code {}", exit_code_of_process.load());
        }
        std::thread(end_at_deadline).detach();
        stop();
      }) {}

ShutdownWatch::~ShutdownWatch() {
  unused_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);  // wakes it when the server ended by itself
  thread_.join();
}

}  // namespace raywalk
