// Answers with the web client's files: caching, compression, the rules for browsers.
#include "server/http/site.h"

#include <gtest/gtest.h>

namespace raywalk::http {
namespace {

constexpr SiteFile kSite[] = {
    {"/index.html", "text/html; charset=utf-8", "<p>plain</p>", "packed", "\"one\"", false},
    {"/assets/main-0123abcd.js", "text/javascript", "code", "", "\"two\"", true},
};

std::optional<Response> get(const std::string& path, std::map<std::string, std::string> headers = {}) {
  Request request;
  request.method = "GET";
  request.path = path;
  request.headers = std::move(headers);
  return site_response(kSite, request);
}

TEST(Site, TheRootIsThePage) {
  const auto answer = get("/");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(answer->body, "<p>plain</p>");
  EXPECT_EQ(answer->content_type, "text/html; charset=utf-8");
  EXPECT_EQ(answer->headers.at("Cache-Control"), "no-cache");
  EXPECT_NE(answer->headers.at("Content-Security-Policy").find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(answer->headers.at("Content-Security-Policy").find("unsafe"), std::string::npos);
}

TEST(Site, OtherPathsAreNotItsOwn) {
  for (const char* path : {"", "/index", "/assets/", "/v1/system", "/../index.html", "//index.html"}) {
    EXPECT_FALSE(get(path)) << path;
  }
}

TEST(Site, WhatHasAHashInItsNameIsKept) {
  EXPECT_EQ(get("/assets/main-0123abcd.js")->headers.at("Cache-Control"), "public, max-age=31536000, immutable");
}

TEST(Site, CompressedForThoseWhoTakeIt) {
  for (const char* accept : {"gzip", "br, gzip", "deflate;q=0.5,\tgzip;q=0.5", "gzip;q=1.0"}) {
    const auto answer = get("/", {{"accept-encoding", accept}});
    EXPECT_EQ(answer->body, "packed") << accept;
    EXPECT_EQ(answer->headers.at("Content-Encoding"), "gzip");
  }
  for (const char* accept : {"", "identity", "xgzip", "gzip;q=0", "gzip; q=0.000, br"}) {
    const auto answer = get("/", {{"accept-encoding", accept}});
    EXPECT_EQ(answer->body, "<p>plain</p>") << accept;
    EXPECT_FALSE(answer->headers.contains("Content-Encoding")) << accept;
  }
  EXPECT_FALSE(get("/assets/main-0123abcd.js", {{"accept-encoding", "gzip"}})->headers.contains("Content-Encoding"));
}

TEST(Site, NotSentAgainWhenItHasNotChanged) {
  for (const char* known : {"\"one\"", "W/\"one\"", "\"other\", W/\"one\"", "*"}) {
    const auto answer = get("/", {{"if-none-match", known}});
    EXPECT_EQ(answer->status, 304) << known;
    EXPECT_TRUE(answer->body.empty()) << known;
    EXPECT_EQ(answer->headers.at("ETag"), "W/\"one\"");
  }
  EXPECT_EQ(get("/", {{"if-none-match", "\"two\""}})->status, 200);
}

TEST(Site, TheBuiltClientIsWhole) {
  bool has_page = false;
  for (const SiteFile& file : embedded_site()) {
    EXPECT_FALSE(file.bytes.empty()) << file.path;
    EXPECT_FALSE(file.etag.empty()) << file.path;
    has_page = has_page || file.path == "/index.html";
  }
  EXPECT_TRUE(has_page);
}

}  // namespace
}  // namespace raywalk::http
