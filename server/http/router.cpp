// Path matching, segment by segment.
#include "server/http/router.h"

#include <algorithm>
#include <stdexcept>

#include "server/http/problem.h"

namespace raywalk::http {
namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> segments;
  std::size_t begin = 1;
  while (begin <= path.size()) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    segments.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return segments;
}

bool is_variable(const std::string& segment) {
  return segment.starts_with('{');
}

std::optional<std::map<std::string, std::string>> match(const std::vector<std::string>& pattern,
                                                        const std::vector<std::string>& path) {
  if (pattern.size() != path.size()) return std::nullopt;
  std::map<std::string, std::string> variables;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (is_variable(pattern[i])) {
      variables[pattern[i].substr(1, pattern[i].size() - 2)] = path[i];
    } else if (pattern[i] != path[i]) {
      return std::nullopt;
    }
  }
  return variables;
}

}  // namespace

Router::Router(const Contract& contract, std::vector<Route> routes) {
  for (const Operation& operation : contract.operations()) {
    const auto route = std::find_if(routes.begin(), routes.end(), [&](const Route& r) {
      return r.method == operation.method && r.pattern == operation.pattern;
    });
    if (route == routes.end()) throw std::logic_error("no handler for " + operation.method + " " + operation.pattern);
    entries_.push_back({&operation, std::move(route->handler), split(operation.pattern)});
    routes.erase(route);
  }
  if (!routes.empty()) throw std::logic_error("not in the contract: " + routes[0].method + " " + routes[0].pattern);
}

Router::Match Router::find(const std::string& method, const std::string& path) const {
  const std::vector<std::string> segments = split(path);
  const std::string wanted = method == "HEAD" ? "GET" : method;
  bool path_exists = false;
  for (const Entry& entry : entries_) {
    auto variables = match(entry.segments, segments);
    if (!variables) continue;
    if (entry.operation->method == wanted) return {&entry, std::move(*variables)};
    path_exists = true;
  }
  if (path_exists) {
    throw ApiError(405, "method_not_allowed", "This path takes " + allowed_methods(path) + ", not " + method + ".");
  }
  throw ApiError(404, "not_found", "There is nothing at this path; GET /v1/openapi.json lists what there is.");
}

std::string Router::allowed_methods(const std::string& path) const {
  std::string methods;
  for (const Entry& entry : entries_) {
    if (!match(entry.segments, split(path))) continue;
    if (!methods.empty()) methods += ", ";
    methods += entry.operation->method;
    if (entry.operation->method == "GET") methods += ", HEAD";
  }
  return methods;
}

}  // namespace raywalk::http
