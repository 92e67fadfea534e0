// Words, strings and punctuation of Open Inventor files.
#pragma once
#include <string_view>

#include "kernels/platform.h"

namespace raywalk {

enum class IvTokenKind { kEnd, kWord, kString, kPunctuation };

struct IvToken {
  IvTokenKind kind = IvTokenKind::kEnd;
  std::string_view text;  // of a string: what is between the quotes, as it was written
  u32 line = 1;

  bool is(char punctuation) const { return kind == IvTokenKind::kPunctuation && text[0] == punctuation; }
  bool is_word(std::string_view word) const { return kind == IvTokenKind::kWord && text == word; }
};

/// Punctuation is one of {}[]()|~= alone; commas are white space; # begins a comment.
class IvLexer {
 public:
  explicit IvLexer(std::string_view text) : rest_(text) { take(); }

  const IvToken& peek() const { return token_; }
  IvToken take();

 private:
  void skip_space();

  std::string_view rest_;
  u32 line_ = 1;
  IvToken token_;
};

}  // namespace raywalk
