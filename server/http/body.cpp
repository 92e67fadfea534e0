// Reads bodies into memory or a file.
#include "server/http/body.h"

#include <stdlib.h>
#include <unistd.h>

#include "server/http/problem.h"

namespace raywalk::http {
namespace {

constexpr const char* kPrefix = "upload-";

/// `take` gets the pieces up to `limit` bytes.
void read_counted(const Reader& reader, std::size_t limit, const std::function<bool(const char*, std::size_t)>& take) {
  std::size_t total = 0;
  bool too_large = false;
  const bool complete = reader([&](const char* data, std::size_t size) {
    total += size;
    too_large = total > limit;
    return !too_large && take(data, size);
  });
  if (too_large) {
    throw ApiError(413, "body_too_large", "The body is larger than " + std::to_string(limit) + " bytes.");
  }
  if (!complete) throw ApiError(400, "incomplete_body", "The body ended early.");
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& dir) {
  std::string name = (dir / (std::string(kPrefix) + "XXXXXX")).string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw std::runtime_error("cannot create a file in " + dir.string());
  close(descriptor);
  path_ = name;
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove(path_, ignored);
}

void TemporaryFile::remove_leftovers(const std::filesystem::path& dir) {
  std::error_code ignored;  // what cannot be removed does no harm
  for (const auto& entry : std::filesystem::directory_iterator(dir, ignored)) {
    if (entry.path().filename().string().starts_with(kPrefix)) std::filesystem::remove(entry.path(), ignored);
  }
}

std::string read_bytes(const Reader& reader, std::size_t limit) {
  std::string bytes;
  read_counted(reader, limit, [&](const char* data, std::size_t size) {
    bytes.append(data, size);
    return true;
  });
  return bytes;
}

TemporaryFile read_file(const Reader& reader, std::size_t limit, const std::filesystem::path& dir) {
  TemporaryFile file(dir);
  std::ofstream out(file.path(), std::ios::binary | std::ios::trunc);
  read_counted(reader, limit, [&](const char* data, std::size_t size) {
    out.write(data, static_cast<std::streamsize>(size));
    return true;  // a full disk is reported below, as what it is
  });
  out.close();
  if (!out) throw ApiError(503, "storage_full", "The upload could not be stored by the daemon.");
  return file;
}

}  // namespace raywalk::http
