// Plain request and response: what handlers see of HTTP.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace raywalk::http {

using Json = nlohmann::json;

/// Checked against its operation in the contract before a handler sees it.
struct Request {
  std::string id;  // also in the log and in X-Request-Id
  std::string method;
  std::string path;
  std::map<std::string, std::string> in_path;
  Json query = Json::object();                 // parameters by name, typed, with the contract's defaults
  std::map<std::string, std::string> headers;  // by lower-case name
  Json json;                                   // the body of a JSON operation, with the contract's defaults
  std::string bytes;                           // the body of a binary operation
  std::filesystem::path file;                  // the body of an upload; deleted after the handler

  const std::string& path_parameter(const std::string& name) const { return in_path.at(name); }
  /// Empty when absent; `name` in lower case.
  std::string header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? std::string() : found->second;
  }
};

/// Writes a piece of a stream; false when the client is gone.
using Write = std::function<bool(std::string_view)>;
/// Called until it returns false. It must come back within a second or so, to see the client leave and the server stop.
using Stream = std::function<bool(const Write&)>;

struct Response {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
  std::map<std::string, std::string> headers = {};
  Stream stream = nullptr;  // instead of `body`
};

inline Response json_response(const Json& value, int status = 200) {
  return {status, "application/json", value.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

inline Response no_content() {
  return {204, "", "", {}, nullptr};
}

using Handler = std::function<Response(const Request&)>;

/// One endpoint. `pattern` is the path of the contract, such as /v1/scenes/{scene}.
struct Route {
  std::string method;
  std::string pattern;
  Handler handler;
};

}  // namespace raywalk::http
