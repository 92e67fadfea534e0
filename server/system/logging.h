// The log on stderr, for people or for programs.
#pragma once
#include <string>

namespace raywalk {

/// `level` is debug, info, warn or error. With `json` each line is one JSON object.
void set_up_logging(const std::string& level, bool json);

}  // namespace raywalk
