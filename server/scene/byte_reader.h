// Reads a file, gzip or plain, in chunks and knows where it is: the byte and the line for messages.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/platform.h"

struct gzFile_s;

namespace raywalk {

class ByteReader {
 public:
  /// Throws std::runtime_error naming the file if it is not a readable regular file.
  explicit ByteReader(const std::filesystem::path& path);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Pointer to the next `count` bytes, which stay unread until `skip`; nullptr if the file ends before them.
  /// Valid until the next call. Throws std::runtime_error for damaged gzip data.
  const u8* peek(size_t count) { return end_ - begin_ >= count ? buffer_.data() + begin_ : refill(count); }
  /// The next bytes, at most `most` (above 0), which stay unread; none at the end of the file.
  std::span<const u8> peek_some(size_t most);
  /// Marks peeked bytes as read.
  void skip(size_t count) { begin_ += count; }
  /// Skips any number of bytes; false if the file ends before them.
  bool skip_far(u64 count);
  /// The next line without its end ("\n" or "\r\n"), marked as read; false at the end of the file. Valid until the
  /// next call. Throws std::runtime_error for a line over 16 MiB.
  bool next_line(std::string_view& line);

  /// Position in the uncompressed data.
  u64 byte() const { return consumed_ + begin_; }
  /// Number of the line that next_line gave last, from 1.
  u64 line() const { return line_; }
  /// No more than this many bytes can follow; exact for plain files, an upper bound of what deflate reaches for gzip.
  u64 most_bytes_left() const;
  /// No file made by a usual compressor holds more; for plain files the same as most_bytes_left().
  u64 likely_bytes_left() const;
  const std::filesystem::path& path() const { return path_; }

  /// Throws std::runtime_error "<file>, line <n>: <message>" and the same with "byte".
  [[noreturn]] void fail_at_line(const std::string& message) const;
  [[noreturn]] void fail_at_byte(const std::string& message) const;

 private:
  const u8* refill(size_t count);
  u64 bytes_left(u64 ratio) const;

  std::filesystem::path path_;
  gzFile_s* file_ = nullptr;
  u64 stored_bytes_ = 0;
  bool compressed_ = false;
  std::vector<u8> buffer_;
  size_t begin_ = 0, end_ = 0;  // unread part of the buffer
  u64 consumed_ = 0;            // bytes before the buffer
  u64 line_ = 0;
};

}  // namespace raywalk
