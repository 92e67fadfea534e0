// Chunked reading through zlib, which passes plain files on unchanged.
#include "server/scene/byte_reader.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace raywalk {
namespace {

constexpr size_t kChunkBytes = 1 << 18;
constexpr size_t kLongestLine = 16 << 20;
constexpr u64 kDeflateLimit = 1032;  // deflate never packs better than this
constexpr u64 kLikelyRatio = 24;     // mesh data packs 2 to 8 times

}  // namespace

ByteReader::ByteReader(const std::filesystem::path& path) : path_(path), buffer_(kChunkBytes) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw std::runtime_error(path.string() + ": no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw std::runtime_error(path.string() + ": not a regular file");
  stored_bytes_ = std::filesystem::file_size(path, error);
  file_ = gzopen(path.c_str(), "rb");
  if (error || file_ == nullptr) throw std::runtime_error(path.string() + ": cannot be opened for reading");
  gzbuffer(file_, kChunkBytes);
  compressed_ = gzdirect(file_) == 0;
}

ByteReader::~ByteReader() {
  gzclose(file_);
}

const u8* ByteReader::refill(size_t count) {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  consumed_ += begin_;
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < count) buffer_.resize(std::max(count, 2 * buffer_.size()));
  while (end_ < count) {
    const int got =
        gzread(file_, buffer_.data() + end_, static_cast<unsigned>(std::min(buffer_.size() - end_, kChunkBytes)));
    int code = Z_OK;
    const char* reason = gzerror(file_, &code);
    if (got < 0 || (code != Z_OK && code != Z_STREAM_END)) {
      throw std::runtime_error(path_.string() + ", byte " + std::to_string(consumed_ + end_) +
                               ": damaged or truncated " + (compressed_ ? "gzip data" : "file") + " (" + reason + ")");
    }
    if (got == 0) return nullptr;
    end_ += static_cast<size_t>(got);
  }
  return buffer_.data();
}

std::span<const u8> ByteReader::peek_some(size_t most) {
  peek(most);
  return {buffer_.data() + begin_, std::min(most, end_ - begin_)};
}

bool ByteReader::skip_far(u64 count) {
  while (count > 0) {
    const size_t step = static_cast<size_t>(std::min<u64>(count, kChunkBytes));
    if (peek(step) == nullptr) return false;
    skip(step);
    count -= step;
  }
  return true;
}

bool ByteReader::next_line(std::string_view& line) {
  size_t searched = 0;
  size_t length = 0;
  for (size_t wanted = 1;; wanted = end_ - begin_ + 1) {
    if (peek(wanted) == nullptr) {
      if (end_ == begin_) return false;
      length = end_ - begin_;  // the last line may lack its end
      break;
    }
    const u8* start = buffer_.data() + begin_;
    const void* found = std::memchr(start + searched, '\n', end_ - begin_ - searched);
    if (found != nullptr) {
      length = static_cast<size_t>(static_cast<const u8*>(found) - start) + 1;
      break;
    }
    searched = end_ - begin_;
    if (searched > kLongestLine) {
      ++line_;
      fail_at_line("the line is longer than 16 MiB");
    }
  }
  ++line_;
  line = {reinterpret_cast<const char*>(buffer_.data() + begin_), length};
  begin_ += length;
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

u64 ByteReader::bytes_left(u64 ratio) const {
  const u64 most = compressed_ ? stored_bytes_ * ratio : stored_bytes_;
  return most > byte() ? most - byte() : 0;
}

u64 ByteReader::most_bytes_left() const {
  return bytes_left(kDeflateLimit);
}

u64 ByteReader::likely_bytes_left() const {
  return bytes_left(kLikelyRatio);
}

void ByteReader::fail_at_line(const std::string& message) const {
  throw std::runtime_error(path_.string() + ", line " + std::to_string(line_) + ": " + message);
}

void ByteReader::fail_at_byte(const std::string& message) const {
  throw std::runtime_error(path_.string() + ", byte " + std::to_string(byte()) + ": " + message);
}

}  // namespace raywalk
