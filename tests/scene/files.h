// Where the scenes are, and the bytes of test files.
#pragma once
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "kernels/platform.h"
#include "tests/support/folder.h"

namespace raywalk::test {

inline std::filesystem::path scenes_dir() {
  return RAYWALK_SCENES_DIR;
}

/// Appends numbers as bytes of either order.
class Bytes {
 public:
  explicit Bytes(bool big_endian) : big_endian_(big_endian) {}
  template <class T>
  Bytes& add(T value) {
    u8 bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (size_t i = 0; i < sizeof(T); ++i) text_ += static_cast<char>(bytes[big_endian_ ? sizeof(T) - 1 - i : i]);
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  bool big_endian_;
  std::string text_;
};

/// The message of the exception that the call throws; empty if it throws none.
template <class Call>
std::string message_of(Call call) {
  try {
    call();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

}  // namespace raywalk::test
