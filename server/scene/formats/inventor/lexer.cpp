// One token ahead.
#include "server/scene/formats/inventor/lexer.h"

#include <algorithm>

namespace raywalk {
namespace {

constexpr std::string_view kSpace = " \t\r\n,\v\f";
constexpr std::string_view kPunctuation = "{}[]()|~=";
constexpr std::string_view kEndOfWord = " \t\r\n,\v\f{}[]()|~=\"#";

}  // namespace

void IvLexer::skip_space() {
  size_t at = 0;
  while (at < rest_.size()) {
    if (rest_[at] == '#') {
      at = rest_.find('\n', at);
      if (at == rest_.npos) at = rest_.size();
    } else if (kSpace.find(rest_[at]) == kSpace.npos) {
      break;
    } else {
      line_ += rest_[at++] == '\n';
    }
  }
  rest_.remove_prefix(at);
}

IvToken IvLexer::take() {
  const IvToken taken = token_;
  skip_space();
  token_ = {IvTokenKind::kEnd, {}, line_};
  if (rest_.empty()) return taken;
  size_t length = 1;
  if (rest_[0] == '"') {
    token_.kind = IvTokenKind::kString;
    for (; length < rest_.size() && rest_[length] != '"'; ++length) {
      if (rest_[length] == '\\' && length + 1 < rest_.size()) ++length;
      line_ += rest_[length] == '\n';
    }
    token_.text = rest_.substr(1, length - 1);
    if (length < rest_.size()) ++length;
  } else if (kPunctuation.find(rest_[0]) != kPunctuation.npos) {
    token_.kind = IvTokenKind::kPunctuation;
    token_.text = rest_.substr(0, 1);
  } else {
    token_.kind = IvTokenKind::kWord;
    length = std::min(rest_.find_first_of(kEndOfWord, 1), rest_.size());
    token_.text = rest_.substr(0, length);
  }
  rest_.remove_prefix(length);
  return taken;
}

}  // namespace raywalk
