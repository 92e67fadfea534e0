// Reads the marker segments of each strip and keeps the coded data between them.
#include "server/image/jpeg_strips.h"

#include <stdexcept>
#include <string_view>

namespace raywalk {
namespace {

enum Marker : u8 { kStartOfFrame = 0xc0, kRestart = 0xd0, kStart = 0xd8, kEnd = 0xd9, kScan = 0xda, kInterval = 0xdd };

/// A JPEG taken apart; all views into its bytes.
struct Parts {
  std::string_view head;   // before the frame header
  std::string_view frame;  // its marker, length and contents
  std::string_view tables;
  std::string_view scan;  // the scan's header
  std::string_view data;  // entropy coded
};

u8 byte_at(std::string_view text, std::size_t i) {
  if (i >= text.size()) throw std::runtime_error("a JPEG strip ends too early");
  return static_cast<u8>(text[i]);
}
u32 word_at(std::string_view text, std::size_t i) {
  return u32{byte_at(text, i)} << 8 | byte_at(text, i + 1);
}
std::string word(u32 value) {
  return {static_cast<char>(value >> 8), static_cast<char>(value & 255)};
}
std::string marker(u32 code) {
  return {static_cast<char>(0xff), static_cast<char>(code)};
}

Parts parts_of(std::string_view jpeg) {
  const auto expect = [](bool fine) {
    if (!fine) throw std::runtime_error("a strip is not a baseline JPEG");
  };
  expect(word_at(jpeg, 0) == (0xff00u | kStart) && jpeg.ends_with(marker(kEnd)));
  Parts parts;
  std::size_t at = 2, after_frame = 0;
  for (;;) {
    expect(byte_at(jpeg, at) == 0xff);
    const u8 code = byte_at(jpeg, at + 1);
    const std::size_t size = 2 + word_at(jpeg, at + 2);
    expect(at + size <= jpeg.size());
    if (code == kStartOfFrame) {
      parts.head = jpeg.substr(0, at);
      parts.frame = jpeg.substr(at, size);
      after_frame = at + size;
    }
    if (code == kScan) {
      expect(after_frame != 0);
      parts.tables = jpeg.substr(after_frame, at - after_frame);
      parts.scan = jpeg.substr(at, size);
      parts.data = jpeg.substr(at + size, jpeg.size() - 2 - (at + size));
      return parts;
    }
    at += size;
  }
}

/// Blocks that are coded together, in a strip of kJpegStripRows rows.
u32 interval_of(std::string_view frame) {
  const u32 width = word_at(frame, 7), components = byte_at(frame, 9);
  u32 across = 1, down = 1;
  for (u32 i = 0; i < components; ++i) {
    const u8 sampling = byte_at(frame, 11 + 3 * i);
    across = larger(across, u32{sampling} >> 4);
    down = larger(down, u32{sampling} & 15u);
  }
  return (width + 8 * across - 1) / (8 * across) * (kJpegStripRows / (8 * down));
}

}  // namespace

std::string join_jpeg_strips(const std::vector<std::string>& strips, u32 height) {
  const Parts first = parts_of(strips.at(0));
  std::string all(first.head);
  const std::size_t height_at = all.size() + 5;
  all += first.frame;
  all.replace(height_at, 2, word(height));
  all += first.tables;
  all += marker(kInterval) + word(4) + word(interval_of(first.frame));
  all += first.scan;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (i > 0) all += marker(kRestart + static_cast<u32>((i - 1) % 8));
    all += parts_of(strips[i]).data;
  }
  return all + marker(kEnd);
}

}  // namespace raywalk
