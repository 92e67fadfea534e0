// JSON text to values, with refusals that people can act on.
#pragma once
#include <string_view>

#include "server/http/message.h"

namespace raywalk::http {

/// Parses JSON at most 32 deep; whole numbers written as 1.0 or 1e3 become integers, as JSON Schema sees them.
/// Throws ApiError 400 malformed_json, or duplicate_field for an object that has a field twice.
Json parse_json(std::string_view text);

}  // namespace raywalk::http
