// Words in messages.
#include "server/scene/text.h"

namespace raywalk {

std::string in_quotes(std::string_view word) {
  constexpr size_t kMost = 100;
  std::string text = "'";
  for (const char c : word.substr(0, kMost)) {
    const bool control = (c >= 0 && c < ' ') || c == 0x7f;
    text += control ? '?' : c;
  }
  return text + (word.size() > kMost ? "...'" : "'");
}

}  // namespace raywalk
