// Host and Origin checks.
#include "server/http/guard.h"

#include <algorithm>
#include <cctype>

namespace raywalk::http {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::tolower(c); });
  return out;
}

/// The name without its port; brackets of an IPv6 address stay. Empty if the port is no number.
std::string name_of(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  const std::size_t bracket = host.rfind(']');
  if (colon == std::string_view::npos || (bracket != std::string_view::npos && colon < bracket)) return lower(host);
  const std::string_view port = host.substr(colon + 1);
  if (!std::all_of(port.begin(), port.end(), [](unsigned char c) { return std::isdigit(c); })) return {};
  return lower(host.substr(0, colon));
}

}  // namespace

bool Guard::host_allowed(std::string_view host) const {
  const std::string name = name_of(host);
  return name == "localhost" || name == "127.0.0.1" || name == "[::1]" || (!name.empty() && name == bind_host_);
}

bool Guard::origin_allowed(std::string_view origin) const {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.starts_with(scheme)) return host_allowed(origin.substr(scheme.size()));
  }
  return false;
}

bool has_control_characters(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < 0x20 && c != '\t') || c == 0x7f; });
}

}  // namespace raywalk::http
