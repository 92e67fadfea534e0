// Row by row access to the data of a PLY file, the same for text and binary.
#pragma once
#include <bit>
#include <cstring>
#include <string>

#include "server/scene/formats/ply/header.h"
#include "server/scene/text.h"

namespace raywalk {

/// Text: one row a line, blank lines between rows are allowed.
class PlyTextRows {
 public:
  explicit PlyTextRows(ByteReader& reader) : reader_(reader) {}

  void begin_row(const PlyElement& element, u64 row) {
    element_ = &element;
    row_ = row;
    std::string_view line;
    do {
      if (!reader_.next_line(line)) {
        fail("the file ends after " + std::to_string(row) + " of " + std::to_string(element.count) +
             " rows of element " + element.name);
      }
      words_ = TokenReader(line);
      ahead_ = words_.next();
    } while (ahead_.empty());
  }
  void end_row() {
    if (!ahead_.empty()) fail(row_name() + " has more values than the header says");
  }
  float real(PlyType type) { return is_integer(type) ? static_cast<float>(parsed<long long>()) : parsed<float>(); }
  long long integer(PlyType) { return parsed<long long>(); }
  void ignore(PlyType) { word(); }
  /// Skips all rows of an element that is not wanted.
  void ignore_rows(const PlyElement& element) {
    for (u64 row = 0; row < element.count; ++row) begin_row(element, row);
  }
  [[noreturn]] void fail(const std::string& message) const { reader_.fail_at_line(message); }

 private:
  std::string_view word() {
    if (ahead_.empty()) fail(row_name() + " has fewer values than the header says");
    const std::string_view now = ahead_;
    ahead_ = words_.next();
    return now;
  }
  template <class T>
  T parsed() {
    const std::string_view text = word();
    T value{};
    if (!parse_number(text, value)) {
      fail(in_quotes(text) + " is not " + (std::is_same_v<T, float> ? "a number" : "an integer"));
    }
    return value;
  }
  std::string row_name() const { return element_->name + " " + std::to_string(row_); }

  ByteReader& reader_;
  const PlyElement* element_ = nullptr;
  u64 row_ = 0;
  TokenReader words_{""};
  std::string_view ahead_;
};

template <bool kSwapBytes>
class PlyBinaryRows {
 public:
  explicit PlyBinaryRows(ByteReader& reader) : reader_(reader) {}

  void begin_row(const PlyElement& element, u64 row) {
    element_ = &element;
    row_ = row;
  }
  void end_row() {}
  float real(PlyType type) {
    if (type == PlyType::kFloat) return value<float, u32>();
    if (type == PlyType::kDouble) return static_cast<float>(value<double, u64>());
    return static_cast<float>(integer(type));
  }
  long long integer(PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return value<signed char, u8>();
      case PlyType::kUint8:
        return value<u8, u8>();
      case PlyType::kInt16:
        return value<short, unsigned short>();
      case PlyType::kUint16:
        return value<unsigned short, unsigned short>();
      case PlyType::kInt32:
        return value<i32, u32>();
      default:
        return value<u32, u32>();
    }
  }
  void ignore(PlyType type) { take(size_bytes_of(type)); }
  void ignore_rows(const PlyElement& element) {
    bool has_list = false;
    for (const PlyProperty& p : element.properties) has_list |= p.is_list;
    begin_row(element, element.count);
    if (!has_list) {
      if (!reader_.skip_far(element.count * element.least_row_bytes(PlyEncoding::kLittleEndian))) fail_truncated();
      return;
    }
    for (u64 row = 0; row < element.count; ++row) {
      begin_row(element, row);
      for (const PlyProperty& p : element.properties) {
        const long long n = p.is_list ? integer(p.count_type) : 1;
        if (n < 0) fail("a list of negative length");
        if (!reader_.skip_far(static_cast<u64>(n) * size_bytes_of(p.type))) fail_truncated();
      }
    }
  }
  [[noreturn]] void fail(const std::string& message) const { reader_.fail_at_byte(message); }

 private:
  [[noreturn]] void fail_truncated() const {
    fail("the file ends within element " + element_->name + ", row " + std::to_string(row_) + " of " +
         std::to_string(element_->count));
  }
  const u8* take(size_t size_bytes) {
    const u8* bytes = reader_.peek(size_bytes);
    if (bytes == nullptr) fail_truncated();
    reader_.skip(size_bytes);
    return bytes;
  }
  template <class T, class Bits>
  T value() {
    static_assert(sizeof(T) == sizeof(Bits));
    u8 bytes[sizeof(T)];
    std::memcpy(bytes, take(sizeof(T)), sizeof(T));
    Bits bits = 0;
    for (size_t i = 0; i < sizeof(T); ++i) {
      bits = static_cast<Bits>(bits | static_cast<Bits>(Bits{bytes[i]} << 8 * (kSwapBytes ? sizeof(T) - 1 - i : i)));
    }
    return std::bit_cast<T>(bits);
  }

  ByteReader& reader_;
  const PlyElement* element_ = nullptr;
  u64 row_ = 0;
};

}  // namespace raywalk
