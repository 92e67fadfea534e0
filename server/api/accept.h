// Content negotiation (RFC 9110, section 12.5.1).
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace raywalk::api {

/// The offered media type that the Accept header likes best; among equals the first offered. An empty header accepts
/// all. Nothing when none is acceptable.
std::optional<std::string> negotiate(const std::string& accept, const std::vector<std::string>& offered);

}  // namespace raywalk::api
