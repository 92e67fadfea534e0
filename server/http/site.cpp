// Caching, compression and the browser's rules for pages.
#include "server/http/site.h"

#include <algorithm>

namespace raywalk::http {
namespace {

/// Scripts, styles and connections of this daemon alone; images also from what scripts made.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; "
    "manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Whether the comma-separated list names `item`, weights apart. `q=0` refuses it.
bool lists(std::string_view list, std::string_view item) {
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    std::string_view entry = list.substr(0, comma);
    list.remove_prefix(std::min(comma + 1, list.size()));
    entry.remove_prefix(std::min(entry.find_first_not_of(" \t"), entry.size()));
    const std::string_view name = entry.substr(0, entry.find_first_of("; \t"));
    if (name != item) continue;
    const std::size_t weight = entry.find("q=");
    return weight == std::string_view::npos || entry.find_first_of("123456789", weight) != std::string_view::npos;
  }
  return false;
}

/// If-None-Match compares weakly: W/ does not count.
bool matches(std::string_view if_none_match, std::string_view etag) {
  return if_none_match == "*" || if_none_match.find(etag) != std::string_view::npos;
}

}  // namespace

std::optional<Response> site_response(std::span<const SiteFile> site, const Request& request) {
  const std::string_view path = request.path == "/" ? std::string_view("/index.html") : request.path;
  const auto file = std::find_if(site.begin(), site.end(), [&](const SiteFile& f) { return f.path == path; });
  if (file == site.end()) return std::nullopt;
  Response response{200, std::string(file->content_type), "", {}, nullptr};
  response.headers = {{"Cache-Control", file->immutable ? "public, max-age=31536000, immutable" : "no-cache"},
                      {"ETag", "W/" + std::string(file->etag)},
                      {"Vary", "Accept-Encoding"},
                      {"Content-Security-Policy", kContentSecurityPolicy},
                      {"Cross-Origin-Opener-Policy", "same-origin"},
                      {"Cross-Origin-Resource-Policy", "same-origin"},
                      {"Referrer-Policy", "no-referrer"}};
  if (matches(request.header("if-none-match"), file->etag)) {
    response.status = 304;
    return response;
  }
  const bool compressed = !file->gzip.empty() && lists(request.header("accept-encoding"), "gzip");
  if (compressed) response.headers["Content-Encoding"] = "gzip";
  response.body = compressed ? file->gzip : file->bytes;
  return response;
}

}  // namespace raywalk::http
