// Environment variables that name a library.
#pragma once
#include <string>
#include <vector>

#include "server/system/environment.h"

namespace raywalk::cuda {

/// What the variable names, or `usual` when it is not set.
inline std::vector<std::string> named_or(const char* variable, const std::string& usual) {
  const std::string path = environment(variable);
  return {path.empty() ? usual : path};
}

}  // namespace raywalk::cuda
