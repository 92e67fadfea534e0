// Environment variables that name a library.
#pragma once
#include <cstdlib>
#include <string>
#include <vector>

namespace raywalk::cuda {

/// The value; empty when it is not set.
inline std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// What the variable names, or `usual` when it is not set.
inline std::vector<std::string> named_or(const char* variable, const std::string& usual) {
  const std::string path = environment(variable);
  return {path.empty() ? usual : path};
}

}  // namespace raywalk::cuda
