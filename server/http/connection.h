// One connection of cpp-httplib, ended so that a refused client still reads its answer. Only server.cpp includes this.
#pragma once
#define CPPHTTPLIB_USE_POLL
#define CPPHTTPLIB_TCP_NODELAY true
#define CPPHTTPLIB_LISTEN_BACKLOG 512
#include <httplib.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <string>

namespace raywalk::http {

constexpr std::chrono::seconds kLinger{5};

/// Set while a worker answers a request whose body it has not read to the end: the connection cannot be used again.
inline thread_local bool close_connection_after_answer = false;

/// A client that still sends its body would lose the answer if the connection were reset: what it sends is thrown away
/// for a while.
inline void discard_rest(socket_t socket) {
  shutdown(socket, SHUT_WR);
  const auto end = std::chrono::steady_clock::now() + kLinger;
  std::array<char, 65536> buffer;
  while (std::chrono::steady_clock::now() < end) {
    pollfd waiting{socket, POLLIN, 0};
    if (poll(&waiting, 1, 1000) <= 0 || recv(socket, buffer.data(), buffer.size(), 0) <= 0) return;
  }
}

class HttpServer : public httplib::Server {
 private:
  /// Answers are made for each request: no part of one can be asked for.
  static void ignore_ranges(httplib::Request& in) { in.ranges.clear(); }

  bool process_and_close_socket(socket_t socket) override {
    std::string remote_address, local_address;
    int remote_port = 0, local_port = 0;
    httplib::detail::get_remote_ip_and_port(socket, remote_address, remote_port);
    httplib::detail::get_local_ip_and_port(socket, local_address, local_port);
    const bool result = httplib::detail::process_server_socket(
        svr_sock_, socket, keep_alive_max_count_, keep_alive_timeout_sec_, read_timeout_sec_, read_timeout_usec_,
        write_timeout_sec_, write_timeout_usec_, [&](httplib::Stream& stream, bool close_connection, bool& closed) {
          close_connection_after_answer = false;
          const bool ok = process_request(stream, remote_address, remote_port, local_address, local_port,
                                          close_connection, closed, ignore_ranges);
          closed = closed || close_connection_after_answer;
          return ok;
        });
    if (close_connection_after_answer) discard_rest(socket);
    httplib::detail::shutdown_socket(socket);
    httplib::detail::close_socket(socket);
    return result;
  }
};

}  // namespace raywalk::http
