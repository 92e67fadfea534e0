// Finds the operation of a request, checks it against the contract, calls the handler.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/http/contract.h"
#include "server/http/message.h"

namespace raywalk::http {

class Router {
 public:
  struct Entry {
    const Operation* operation;
    Handler handler;
    std::vector<std::string> segments;  // of the pattern
  };
  struct Match {
    const Entry* entry;
    std::map<std::string, std::string> in_path;
  };

  /// Throws std::logic_error unless routes and operations of the contract are one to one.
  Router(const Contract& contract, std::vector<Route> routes);

  /// HEAD finds the GET. Throws ApiError 404 not_found or 405 method_not_allowed.
  Match find(const std::string& method, const std::string& path) const;
  /// Methods of the path, for the Allow header; empty if there is no such path.
  std::string allowed_methods(const std::string& path) const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace raywalk::http
