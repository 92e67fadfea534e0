// Lines, continued ones too, and numbers in them.
#include "server/scene/formats/obj/lines.h"

#include <cmath>
#include <stdexcept>

namespace raywalk {

std::string_view ObjLines::cut() {
  const size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
  ++lines_read_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

bool ObjLines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  number_ = lines_read_ + 1;
  line = cut();
  if (line.ends_with('\\')) {
    joined_.clear();
    while (line.ends_with('\\')) {
      joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
      line = rest_.empty() ? std::string_view() : cut();
    }
    line = joined_.append(line);
  }
  line = line.substr(0, line.find('#'));
  return true;
}

float finite_number(TokenReader& words) {
  const std::string_view word = words.next();
  if (word.empty()) throw std::runtime_error("a number is missing");
  float value = 0.0f;
  if (!parse_number(word, value)) throw std::runtime_error(in_quotes(word) + " is not a number");
  if (!std::isfinite(value)) throw std::runtime_error(in_quotes(word) + " is not a finite number");
  return value;
}

Vec3 finite_vector(TokenReader& words) {
  const float x = finite_number(words);
  const float y = finite_number(words);
  return {x, y, finite_number(words)};
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const size_t begin = text.find_first_not_of(kSpace);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
}

}  // namespace raywalk
