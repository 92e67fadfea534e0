// Request bodies: counted as they arrive, so that chunked ones meet the same limits.
#pragma once
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "server/http/contract.h"

namespace raywalk::http {

/// Delivers a body piece by piece; false when the connection failed or the receiver said stop.
using Reader = std::function<bool(const std::function<bool(const char*, std::size_t)>&)>;

/// A file that is removed with its owner.
class TemporaryFile {
 public:
  TemporaryFile() = default;
  /// A new file in `dir`. Throws std::runtime_error.
  explicit TemporaryFile(const std::filesystem::path& dir);
  /// Removes those that a crashed process left in `dir`, which no other process uses.
  static void remove_leftovers(const std::filesystem::path& dir);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TemporaryFile& operator=(TemporaryFile&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Throws ApiError 413 body_too_large past `limit` bytes, 400 incomplete_body when the client stops early.
std::string read_bytes(const Reader& reader, std::size_t limit);
TemporaryFile read_file(const Reader& reader, std::size_t limit, const std::filesystem::path& dir);

}  // namespace raywalk::http
