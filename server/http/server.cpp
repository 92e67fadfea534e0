// cpp-httplib behind plain types: limits, checks, problem+json, deadlines.
#include "server/http/server.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <random>

#include "server/http/body.h"
#include "server/http/connection.h"
#include "server/http/guard.h"
#include "server/http/problem.h"

namespace raywalk::http {
namespace {

constexpr std::string_view kMethods = "GET, HEAD, POST, PUT, DELETE";
constexpr std::size_t kSmallBody = std::size_t{64} << 10;

std::string new_request_id() {
  static std::atomic<std::uint64_t> counter{0};
  static const std::uint32_t start = std::random_device{}();
  char text[32];
  std::snprintf(text, sizeof text, "%08x-%06llx", start, static_cast<unsigned long long>(++counter));
  return text;
}

std::map<std::string, std::string> lower_case_headers(const httplib::Headers& headers) {
  std::map<std::string, std::string> out;
  for (const auto& [name, value] : headers) {
    std::string key = name;
    std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::tolower(c); });
    out.emplace(std::move(key), value);
  }
  return out;
}

bool has_body(const httplib::Request& in) {
  return in.has_header("Transfer-Encoding") || in.get_header_value_u64("Content-Length") > 0;
}

std::string media_type(const httplib::Request& in) {
  std::string type = in.get_header_value("Content-Type");
  type = type.substr(0, type.find(';'));
  while (!type.empty() && type.back() == ' ') type.pop_back();
  std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::tolower(c); });
  return type;
}

}  // namespace

struct Server::Impl {
  ServerConfig config;
  Router router;
  std::function<void(const Exchange&)> observe;
  Guard guard;
  HttpServer http;
  std::atomic<bool> stopping{false};

  Impl(ServerConfig c, Router r, std::function<void(const Exchange&)> o)
      : config(std::move(c)), router(std::move(r)), observe(std::move(o)), guard(config.host) {}

  std::size_t body_limit(BodyKind kind) const {
    return kind == BodyKind::file    ? config.limits.upload_bytes
           : kind == BodyKind::bytes ? config.limits.rays_bytes
                                     : config.limits.json_bytes;
  }

  /// More than any operation takes.
  bool is_hopelessly_large(const httplib::Request& in) const {
    return in.get_header_value_u64("Content-Length") >
           std::max({config.limits.upload_bytes, config.limits.rays_bytes, config.limits.json_bytes});
  }

  void check_before_routing(const httplib::Request& in) const {
    if (has_control_characters(in.path))
      throw ApiError(400, "control_character", "The path holds a control character.");
    for (const auto& [name, value] : in.headers) {
      if (has_control_characters(value)) {
        throw ApiError(400, "control_character", "A header value holds a control character.");
      }
    }
    if (!guard.host_allowed(in.get_header_value("Host"))) {
      throw ApiError(403, "foreign_host", "The Host header names neither a loopback address nor the bound one.");
    }
    if (in.has_header("Origin") && !guard.origin_allowed(in.get_header_value("Origin"))) {
      throw ApiError(403, "foreign_origin", "Requests from web pages of other origins are refused.");
    }
    if (is_hopelessly_large(in)) throw ApiError(413, "body_too_large", "No path takes a body as large as this.");
  }

  void read_body(const httplib::Request& in, const Reader* reader, const Operation& operation, Request& request,
                 TemporaryFile& file) const {
    if (operation.body == BodyKind::none) return;
    if (media_type(in) != operation.media_type) {
      throw ApiError(415, "unsupported_media_type", "Send the body as Content-Type: " + operation.media_type + ".");
    }
    const std::size_t limit = body_limit(operation.body);
    if (in.get_header_value_u64("Content-Length") > limit) {
      throw ApiError(413, "body_too_large", "The body is larger than " + std::to_string(limit) + " bytes.");
    }
    const Reader nothing = [](const auto&) { return true; };
    const Reader& source = reader != nullptr ? *reader : nothing;
    if (operation.body == BodyKind::file) {
      file = read_file(source, limit, config.upload_dir);
      request.file = file.path();
    } else if (operation.body == BodyKind::bytes) {
      request.bytes = read_bytes(source, limit);
    } else {
      request.json = check_body(operation, read_bytes(source, limit));
    }
  }

  Response handle(const httplib::Request& in, const Reader* reader, Request& request, std::string& route) const {
    TemporaryFile file;
    request.method = in.method;
    request.path = in.path;
    request.headers = lower_case_headers(in.headers);
    check_before_routing(in);
    if (in.method == "GET" || in.method == "HEAD") {
      if (std::optional<Response> page = site_response(config.site, request)) {
        route = "/";
        return std::move(*page);
      }
    }
    Router::Match match = router.find(in.method, in.path);
    const Operation& operation = *match.entry->operation;
    route = operation.pattern;
    request.in_path = std::move(match.in_path);
    check_path(operation, request.in_path);
    request.query = check_query(operation, in.params);
    check_headers(operation, request.headers);
    read_body(in, reader, operation, request, file);
    return match.entry->handler(request);
  }

  /// A small body that nobody wanted is read, to keep the connection; after a large one it ends.
  static void skip_body(const httplib::Request& in, const Reader& reader) {
    const bool plain = !in.has_header("Transfer-Encoding") && !in.is_multipart_form_data();
    const bool small = plain && in.get_header_value_u64("Content-Length") <= kSmallBody;
    close_connection_after_answer = !small || !reader([](const char*, std::size_t) { return true; });
  }

  void answer(const httplib::Request& in, httplib::Response& out, const Reader* reader) {
    const auto begin = std::chrono::steady_clock::now();
    bool started = false, ended = false;
    const Reader tracked = [&](const auto& receive) {
      started = true;
      ended = (*reader)(receive);
      return ended;
    };
    const bool body_waits = reader != nullptr && has_body(in);
    Request request;
    request.id = new_request_id();
    std::string route;
    Response response;
    try {
      response = handle(in, body_waits ? &tracked : nullptr, request, route);
    } catch (...) {
      response = problem_response(problem_of_current_exception(request.id),
                                  has_control_characters(in.path) ? "" : in.path, request.id);
      if (response.status == 405) response.headers["Allow"] = router.allowed_methods(in.path);
    }
    if (body_waits && !started) skip_body(in, *reader);
    if (started && !ended) close_connection_after_answer = true;
    write(std::move(response), request.id, out);
    if (out.status >= 400 || spdlog::should_log(spdlog::level::debug)) log(in, out.status, request.id, begin);
    observe({in.method, route, out.status,
             std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()});
  }

  static void log(const httplib::Request& in, int status, const std::string& id,
                  std::chrono::steady_clock::time_point begin) {
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    const auto level = status >= 500 ? spdlog::level::warn : spdlog::level::debug;
    const std::string path = has_control_characters(in.path) ? "(control characters)" : in.path;
    spdlog::log(level, "request={} {} {} from {} status={} ms={:.2f}", id, in.method, path, in.remote_addr, status, ms);
  }

  void write(Response response, const std::string& id, httplib::Response& out) {
    out.status = response.status;
    out.set_header("X-Request-Id", id);
    out.set_header("X-Content-Type-Options", "nosniff");
    for (const auto& [name, value] : response.headers) out.set_header(name, value);
    if (response.stream) {
      out.set_chunked_content_provider(
          response.content_type, [this, stream = std::move(response.stream)](std::size_t, httplib::DataSink& sink) {
            const Write write = [&sink](std::string_view piece) { return sink.write(piece.data(), piece.size()); };
            if (!stopping && stream(write)) return true;
            sink.done();
            return true;
          });
    } else if (response.status != 204 && response.status != 304) {
      out.set_content(std::move(response.body), response.content_type);
    }
  }

  /// Errors that cpp-httplib finds by itself: unreadable requests, too long addresses.
  void answer_unrouted(const httplib::Request& in, httplib::Response& out) {
    if (!out.body.empty() || out.has_header("X-Request-Id")) return;
    if (out.status == 416 && !has_body(in)) {  // a Range that it cannot read is as good as none
      answer(in, out, nullptr);
      return;
    }
    const std::string id = new_request_id();
    close_connection_after_answer = true;  // where the next request would begin is not known
    Problem problem{out.status, "bad_request", "The request could not be read as HTTP."};
    const bool odd_method = !in.method.empty() && kMethods.find(in.method) == std::string_view::npos;
    if (out.status == 400 && odd_method) {
      problem = {405, "method_not_allowed", "No path takes this method."};
      out.status = 405;
      out.set_header("Allow", std::string(kMethods));
    }
    const Response response = problem_response(problem, has_control_characters(in.path) ? "" : in.path, id);
    out.set_header("X-Request-Id", id);
    out.set_content(response.body, response.content_type);
  }

  void install() {
    const auto with_body = [this](const httplib::Request& in, httplib::Response& out,
                                  const httplib::ContentReader& content) {
      const Reader reader = [&content](const auto& receive) { return content(httplib::ContentReceiver(receive)); };
      answer(in, out, &reader);
    };
    constexpr const char* kAll = R"([\s\S]*)";
    // Methods without a body are answered before httplib would read one into memory.
    http.set_pre_routing_handler([this](const httplib::Request& in, httplib::Response& out) {
      if (in.method == "POST" || in.method == "PUT" || in.method == "PATCH" || in.method == "DELETE") {
        return httplib::Server::HandlerResponse::Unhandled;
      }
      close_connection_after_answer = has_body(in);
      answer(in, out, nullptr);
      return httplib::Server::HandlerResponse::Handled;
    });
    http.Post(kAll, with_body).Put(kAll, with_body).Patch(kAll, with_body).Delete(kAll, with_body);
    http.set_error_handler([this](const httplib::Request& in, httplib::Response& out) { answer_unrouted(in, out); });
    http.set_exception_handler([](const httplib::Request&, httplib::Response& out, std::exception_ptr) {
      out.status = 500;  // the error handler writes the body
    });
    http.set_post_routing_handler([](const httplib::Request&, httplib::Response& out) {
      out.headers.erase("Accept-Ranges");
      if (!close_connection_after_answer) return;
      out.headers.erase("Keep-Alive");
      out.headers.erase("Connection");
      out.set_header("Connection", "close");
    });
    http.set_expect_100_continue_handler([this](const httplib::Request& in, httplib::Response& out) {
      if (!is_hopelessly_large(in)) return 100;
      close_connection_after_answer = true;
      answer(in, out, nullptr);  // a refusal
      return out.status;
    });
    // cpp-httplib's own limit of bodies stays off: they are counted where their operation is known.
    http.set_read_timeout(std::chrono::seconds(10));
    http.set_write_timeout(std::chrono::seconds(10));
    http.set_keep_alive_timeout(5);
    http.set_keep_alive_max_count(100000);
    http.set_socket_options([](socket_t socket) {
      // Not SO_REUSEPORT, which is cpp-httplib's default: two daemons would share a port.
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    http.new_task_queue = [this] {
      return new httplib::ThreadPool(static_cast<std::size_t>(config.threads),
                                     static_cast<std::size_t>(config.threads));
    };
  }
};

Server::Server(ServerConfig config, Router router, std::function<void(const Exchange&)> observe)
    : impl_(std::make_unique<Impl>(std::move(config), std::move(router), std::move(observe))) {
  TemporaryFile::remove_leftovers(impl_->config.upload_dir);
  impl_->install();
}

Server::~Server() = default;

int Server::bind() {
  const ServerConfig& c = impl_->config;
  errno = 0;
  const int port = c.port == 0                                ? impl_->http.bind_to_any_port(c.host)
                   : impl_->http.bind_to_port(c.host, c.port) ? c.port
                                                              : -1;
  if (port > 0) return port;
  const std::string where = c.host + ":" + std::to_string(c.port);
  if (errno == EADDRINUSE)
    throw PortInUse("Port " + std::to_string(c.port) + " is in use; choose another with --port.");
  throw std::runtime_error("Cannot listen on " + where + ": " + std::strerror(errno) + ".");
}

void Server::serve() {
  impl_->http.listen_after_bind();
}

void Server::stop() {
  impl_->stopping = true;
  impl_->http.stop();
}

bool Server::stopping() const {
  return impl_->stopping;
}

}  // namespace raywalk::http
