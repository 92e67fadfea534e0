// Finding the ends of lines and words.
#include "server/scene/formats/mgf/statements.h"

#include <stdexcept>
#include <string>

namespace raywalk {
namespace {

constexpr size_t kMostWords = 10'000;

/// A line end with what escapes it, or a blank; 0 if the word goes on.
size_t blank_length(std::string_view text) {
  if (text[0] == ' ' || text[0] == '\t' || text[0] == '\r' || text[0] == '\n') return 1;
  if (text.starts_with("\\\n")) return 2;
  if (text.starts_with("\\\r\n")) return 3;
  return 0;
}

void split(std::string_view text, std::vector<std::string_view>& words) {
  words.clear();
  while (!text.empty()) {
    if (const size_t blank = blank_length(text); blank > 0) {
      text.remove_prefix(blank);
      continue;
    }
    if (words.empty() && text[0] == '#') return;
    if (words.size() == kMostWords) {
      throw std::runtime_error("a statement of more than " + std::to_string(kMostWords) + " words");
    }
    size_t end = 1;
    while (end < text.size() && blank_length(text.substr(end)) == 0) ++end;
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

}  // namespace

bool StatementReader::next(std::vector<std::string_view>& words) {
  while (offset_ < text_.size()) {
    const size_t begin = offset_;
    first_line_ = lines_ + 1;
    size_t end = 0;
    for (bool escaped = true; escaped;) {
      end = text_.find('\n', offset_);
      if (end == text_.npos) end = text_.size();
      offset_ = end < text_.size() ? end + 1 : end;
      ++lines_;
      const size_t last = end > begin && text_[end - 1] == '\r' ? end - 1 : end;
      escaped = offset_ < text_.size() && last > begin && text_[last - 1] == '\\';
    }
    split(text_.substr(begin, end - begin), words);
    if (!words.empty()) return true;
  }
  return false;
}

}  // namespace raywalk
