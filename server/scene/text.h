// Words and numbers out of text, whatever the locale says.
#pragma once
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

#include "kernels/platform.h"

namespace raywalk {

/// Splits at spaces and tabs.
class TokenReader {
 public:
  explicit TokenReader(std::string_view text) : rest_(text) {}
  /// Empty when there is none left.
  std::string_view next() {
    size_t begin = 0;
    while (begin < rest_.size() && is_space(rest_[begin])) ++begin;
    size_t end = begin;
    while (end < rest_.size() && !is_space(rest_[end])) ++end;
    const std::string_view token = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return token;
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  std::string_view rest_;
};

/// A word of a file as a message shows it: in quotes, without control characters, and cut if it is long.
std::string in_quotes(std::string_view word);

/// The whole token as a number; false if it is none, or does not fit an integer type. Floats beyond the range become
/// infinite or zero, and "nan" and "inf" are numbers.
template <class T>
bool parse_number(std::string_view token, T& value) {
  if (token.starts_with('+')) token.remove_prefix(1);
  const char* end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  if constexpr (std::is_same_v<T, float>) {
    if (result.ec == std::errc::result_out_of_range) {
      double wide = 0.0;
      const std::from_chars_result again = std::from_chars(token.data(), end, wide);
      const bool tiny = token.find("e-") != token.npos || token.find("E-") != token.npos;
      if (again.ec == std::errc::result_out_of_range) wide = tiny ? 0.0 : token[0] == '-' ? -1e300 : 1e300;
      value = static_cast<float>(wide);
      return again.ptr == end;
    }
  }
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace raywalk
