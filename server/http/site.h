// The web client's files, embedded when the daemon was built, as answers to GET.
#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "server/http/message.h"

namespace raywalk::http {

/// One file of the built web client.
struct SiteFile {
  std::string_view path;  // as requested, such as /assets/main-1a2b.js
  std::string_view content_type;
  std::string_view bytes;
  std::string_view gzip;  // the same compressed; empty where that saves nothing
  std::string_view etag;  // with its quotes
  bool immutable;         // its name holds a hash of its content
};

/// Made from the files of client/web by client/web/embed.
std::span<const SiteFile> embedded_site();

/// The answer to GET or HEAD of `path`; none when no file has it. `/` is index.html.
std::optional<Response> site_response(std::span<const SiteFile> site, const Request& request);

}  // namespace raywalk::http
