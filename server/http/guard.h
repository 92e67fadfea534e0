// What is refused before routing: foreign Host and Origin headers, control characters.
#pragma once
#include <string>
#include <string_view>

namespace raywalk::http {

/// Loopback is no boundary: a web page in the user's browser can reach it. Only these hosts are answered.
class Guard {
 public:
  /// `bind_host` is answered beside localhost, 127.0.0.1 and [::1].
  explicit Guard(std::string bind_host) : bind_host_(std::move(bind_host)) {}

  /// `host` is a Host header: a name with or without a port.
  bool host_allowed(std::string_view host) const;
  /// `origin` is an Origin header, not empty. The opaque origin `null` is refused.
  bool origin_allowed(std::string_view origin) const;

 private:
  std::string bind_host_;
};

/// True if the text holds a control character other than a tab: it could forge lines of a log or of a header.
bool has_control_characters(std::string_view text);

}  // namespace raywalk::http
