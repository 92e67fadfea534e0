// The words and numbers of one AFF file, in one pass; white space and comments (# and %) lie between them.
#pragma once
#include <filesystem>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "kernels/vec.h"
#include "server/scene/text.h"

namespace raywalk::aff {

/// An error that already names file and line.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Text {
 public:
  /// `file` is for messages and for what lies beside it; both must outlive the text.
  Text(const std::filesystem::path& file, std::string_view text) : file_(file), rest_(text) {}

  const std::filesystem::path& file() const { return file_; }
  /// "<file>, line <n>" of what was read last.
  std::string place() const;
  /// Throws Error with the place.
  [[noreturn]] void fail(const std::string& message) const;

  /// The next word, not taken; empty at the end of the file. Braces are words of their own.
  std::string_view peek();
  /// The next word; empty at the end of the file.
  std::string_view word();
  /// A word that must be there; `what` it stands for.
  std::string_view name(const char* what);
  /// The given word must come next.
  void expect(std::string_view word);
  bool next_is_number();

  /// A finite number, also as a float.
  double real(const char* what) {
    skip_space();
    double value = 0.0;
    return plain_real(value) ? value : other_real(what);
  }
  glm::dvec3 point(const char* what);
  Vec3 color(const char* what);
  long long integer(const char* what);
  /// A count of things that take at least `least_numbers` numbers each, so that a lying one cannot waste memory.
  size_t count(const char* what, size_t least_numbers);
  /// Skips what belongs to an unknown statement: the rest of its line, lines of numbers, a group in braces.
  void skip_statement();

 private:
  void skip_space();
  bool plain_real(double& value);
  double other_real(const char* what);
  void skip_group();

  const std::filesystem::path& file_;
  std::string_view rest_;
  u64 line_ = 1, place_line_ = 1;
};

}  // namespace raywalk::aff
