// The HTTP server: the one seam around cpp-httplib, whose types stay behind it.
#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "server/http/router.h"
#include "server/http/site.h"

namespace raywalk::http {

struct Limits {
  std::size_t json_bytes = std::size_t{1} << 20;
  std::size_t upload_bytes = std::size_t{512} << 20;
  std::size_t rays_bytes = std::size_t{256} << 20;
};

struct ServerConfig {
  std::string host = "127.0.0.1";
  int port = 0;  // 0 = any free one
  Limits limits = {};
  std::filesystem::path upload_dir;     // holds uploads while they are read; of this server alone
  int threads = 256;                    // a connection holds one while it is open
  std::span<const SiteFile> site = {};  // pages beside the contract's paths
};

/// One answered request, for metrics. `route` is the pattern, or empty when nothing matched.
struct Exchange {
  std::string method;
  std::string route;
  int status = 0;
  double seconds = 0;
};

class PortInUse : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Server {
 public:
  Server(ServerConfig config, Router router, std::function<void(const Exchange&)> observe);
  ~Server();

  /// Binds and returns the port. Throws PortInUse, or std::runtime_error for an address that cannot be bound.
  int bind();
  /// Serves until stop(); the caller's thread accepts connections.
  void serve();
  /// Takes no more connections and lets open ones end; from any thread.
  void stop();
  /// True once stop() was called: streams end themselves.
  bool stopping() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace raywalk::http
