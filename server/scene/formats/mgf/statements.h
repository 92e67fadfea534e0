// MGF's text as statements: one a line, words split at white space.
#pragma once
#include <string_view>
#include <vector>

#include "kernels/platform.h"

namespace raywalk {

class StatementReader {
 public:
  /// A place to go back to.
  struct Mark {
    size_t offset;
    u64 line;
  };

  /// `text` must outlive the reader and all words.
  explicit StatementReader(std::string_view text) : text_(text) {}

  /// The words of the next statement; blank lines and comments are passed over, `\` at the end of a line counts as a
  /// space. False at the end. Throws std::runtime_error if there are absurdly many words.
  bool next(std::vector<std::string_view>& words);

  /// Where the last statement began, from 1.
  u64 line() const { return first_line_; }
  /// Behind the last statement.
  Mark mark() const { return {offset_, lines_}; }
  void go_to(Mark mark) {
    offset_ = mark.offset;
    lines_ = mark.line;
  }

 private:
  std::string_view text_;
  size_t offset_ = 0;
  u64 lines_ = 0;  // that have been passed
  u64 first_line_ = 0;
};

}  // namespace raywalk
