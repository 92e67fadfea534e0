// The lines of OBJ and MTL files.
#pragma once
#include <string>
#include <string_view>

#include "kernels/vec.h"
#include "server/scene/text.h"

namespace raywalk {

/// Takes a text apart into lines; one that ends with a backslash goes on in the next.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : rest_(text) {}

  /// False at the end of the text. A line is valid until the next call; comments are cut off.
  bool next(std::string_view& line);
  /// Of the line that next() gave (its first one), from 1.
  u64 number() const { return number_; }

 private:
  std::string_view cut();

  std::string_view rest_;
  std::string joined_;
  u64 number_ = 0, lines_read_ = 0;
};

/// The next word as a finite number. Throws std::runtime_error if it is none.
float finite_number(TokenReader& words);
/// The next three.
Vec3 finite_vector(TokenReader& words);

/// Without white space at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace raywalk
