// fork and exec of the same program; the supervisor has one thread and touches neither device nor store.
#include "server/supervise.h"

#include <netdb.h>
#include <netinet/in.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <stdexcept>

#include "server/exit_codes.h"
#include "server/http/server.h"

namespace raywalk {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostRestarts = 5;  // within kWindow
constexpr std::chrono::seconds kWindow{60};
constexpr std::chrono::milliseconds kFirstPause{100};  // doubles with every restart in the window
constexpr int kLastingExitCodes[] = {kDone, kBadSetting, kNoDevice, kPortInUse};  // another start would end so too

/// Keeps the port over restarts: a bound socket that never listens, beside which the child may bind and listen because
/// both allow the address to be reused, while the system gives the port to nobody else.
class ReservedPort {
 public:
  ReservedPort(const std::string& host, int port) {
    addrinfo hints{}, *found = nullptr;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE;
    if (const int error = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); error != 0) {
      throw std::runtime_error("Cannot listen on " + host + ": " + gai_strerror(error) + ".");
    }
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, freeaddrinfo);
    int error = 0;
    for (const addrinfo* address = found; address != nullptr && !bound_; address = address->ai_next) {
      error = bind_to(*address);
    }
    if (bound_) return;
    if (error == EADDRINUSE) {
      throw http::PortInUse("Port " + std::to_string(port) + " is in use; choose another with --port.");
    }
    throw std::runtime_error("Cannot listen on " + host + ":" + std::to_string(port) + ": " + std::strerror(error) +
                             ".");
  }
  ~ReservedPort() { close(socket_); }
  ReservedPort(const ReservedPort&) = delete;
  ReservedPort& operator=(const ReservedPort&) = delete;

  int number() const {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                               : reinterpret_cast<const sockaddr_in&>(address).sin_port);
  }

 private:
  /// 0 or the cause.
  int bind_to(const addrinfo& address) {
    socket_ = socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    bound_ = socket_ >= 0 && bind(socket_, address.ai_addr, address.ai_addrlen) == 0;
    if (bound_) return 0;
    const int error = errno;
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
    return error;
  }

  int socket_ = -1;
  bool bound_ = false;
};

sigset_t set_of(std::initializer_list<int> signals) {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : signals) sigaddset(&set, signal);
  return set;
}

/// The child ends in good order when its supervisor dies, and hears of Ctrl-C from it alone.
[[noreturn]] void become_daemon(const std::vector<std::string>& arguments, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(0);
  setpgid(0, 0);
  const sigset_t all = set_of({SIGTERM, SIGINT, SIGCHLD});
  sigprocmask(SIG_UNBLOCK, &all, nullptr);
  std::vector<char*> words;
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv("/proc/self/exe", words.data());
  _exit(127);
}

pid_t start_daemon(const std::vector<std::string>& arguments) {
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(std::string("The daemon cannot be started: ") + std::strerror(errno) + ".");
  if (child == 0) become_daemon(arguments, self);
  return child;
}

struct End {
  int status = 0;
  bool asked = false;  // a signal to stop came before
};

End wait_for_end(pid_t child) {
  const sigset_t signals = set_of({SIGTERM, SIGINT, SIGCHLD});
  End end;
  while (waitpid(child, &end.status, WNOHANG) != child) {
    int signal = 0;
    sigwait(&signals, &signal);
    if (signal == SIGCHLD) continue;
    end.asked = true;
    kill(child, signal);
  }
  return end;
}

/// False when a signal to stop came meanwhile.
bool pause_for(std::chrono::milliseconds pause) {
  const sigset_t signals = set_of({SIGTERM, SIGINT});
  const timespec time{pause.count() / 1000, pause.count() % 1000 * 1'000'000};
  return sigtimedwait(&signals, nullptr, &time) < 0;
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return "by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  const int code = WEXITSTATUS(status);
  return "with exit code " + std::to_string(code) + (code == kDeviceLost ? " (the device was lost)" : "");
}

/// The exit code with which the supervisor ends too; nothing after a crash.
std::optional<int> final_code(const End& end) {
  if (WIFSIGNALED(end.status)) {
    if (!end.asked) return std::nullopt;
    const int signal = WTERMSIG(end.status);  // it may come before the daemon takes signals
    return signal == SIGTERM || signal == SIGINT ? 0 : 1;
  }
  const int code = WEXITSTATUS(end.status);
  const bool lasting = std::ranges::find(kLastingExitCodes, code) != std::end(kLastingExitCodes);
  return lasting || end.asked ? std::optional(code) : std::nullopt;
}

}  // namespace

int supervise(const std::vector<std::string>& given, const std::string& host, int port) {
  const sigset_t child_signal = set_of({SIGCHLD});
  sigprocmask(SIG_BLOCK, &child_signal, nullptr);
  const ReservedPort reserved(host, port);
  std::vector<std::string> arguments = given;  // of a flag that is given twice the last value counts
  arguments.push_back("--supervise=false");
  arguments.push_back("--port=" + std::to_string(reserved.number()));

  std::deque<Clock::time_point> restarts;
  while (true) {
    const pid_t child = start_daemon(arguments);
    const End end = wait_for_end(child);
    const std::string how = how_it_ended(end.status);
    if (const std::optional<int> code = final_code(end)) {
      if (*code != 0 && WIFSIGNALED(end.status)) spdlog::error("the daemon (process {}) ended {}", child, how);
      return *code;
    }
    while (!restarts.empty() && Clock::now() - restarts.front() > kWindow) restarts.pop_front();
    if (restarts.size() == kMostRestarts) {
      throw std::runtime_error("The daemon crashed " + std::to_string(kMostRestarts + 1) + " times within " +
                               std::to_string(kWindow.count()) + " s, the last time " + how +
                               "; it is not started again.");
    }
    const std::chrono::milliseconds pause = kFirstPause * (1 << restarts.size());
    restarts.push_back(Clock::now());
    spdlog::error(
        "the daemon (process {}) ended {}; it is started again in {} ms, restart {} of at most {} within {} s", child,
        how, pause.count(), restarts.size(), kMostRestarts, kWindow.count());
    if (!pause_for(pause)) return 0;
    if (restarts.size() == 1) arguments.push_back("--fault-after=0");
  }
}

}  // namespace raywalk
