// Times as text.
#pragma once
#include <string>

namespace raywalk {

/// Now, as RFC 3339 in UTC with milliseconds.
std::string now_text();

}  // namespace raywalk
