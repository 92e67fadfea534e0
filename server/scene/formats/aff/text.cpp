// Scanning without allocation.
#include "server/scene/formats/aff/text.h"

#include <cmath>

#include "server/scene/scene_builder.h"

namespace raywalk::aff {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
bool ends_word(char c) {
  return is_space(c) || c == '#' || c == '%' || c == '{' || c == '}';
}
bool begins_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

}  // namespace

std::string Text::place() const {
  return at_line(file_, place_line_);
}

void Text::fail(const std::string& message) const {
  throw Error(place() + ": " + message);
}

void Text::skip_space() {
  const char* at = rest_.data();
  const char* const end = at + rest_.size();
  while (at != end) {
    if (*at == '\n') {
      ++line_;
      ++at;
    } else if (is_space(*at)) {
      ++at;
    } else if (*at == '#' || *at == '%') {
      while (at != end && *at != '\n' && *at != '\r') ++at;
    } else {
      break;
    }
  }
  rest_ = {at, static_cast<size_t>(end - at)};
}

std::string_view Text::peek() {
  skip_space();
  if (rest_.empty()) return rest_;
  size_t length = 0;
  while (length < rest_.size() && !ends_word(rest_[length])) ++length;
  return rest_.substr(0, length == 0 ? 1 : length);
}

std::string_view Text::word() {
  const std::string_view word = peek();
  rest_.remove_prefix(word.size());
  if (!word.empty()) place_line_ = line_;
  return word;
}

std::string_view Text::name(const char* what) {
  const std::string_view word = this->word();
  if (word.empty()) fail(std::string("the file ends where ") + what + " should be");
  if (word == "{" || word == "}") fail(std::string("a brace where ") + what + " should be");
  return word;
}

void Text::expect(std::string_view wanted) {
  const std::string_view found = word();
  if (found == wanted) return;
  fail(in_quotes(wanted) + " should be here, not " + (found.empty() ? "the end of the file" : in_quotes(found)));
}

bool Text::next_is_number() {
  skip_space();
  return !rest_.empty() && begins_number(rest_[0]);
}

/// The usual case: digits that std::from_chars takes up to the end of the word.
bool Text::plain_real(double& value) {
  if (rest_.empty() || !begins_number(rest_[0])) return false;
  const char* const end = rest_.data() + rest_.size();
  const auto [stop, error] = std::from_chars(rest_.data(), end, value);
  if (error != std::errc() || (stop != end && !ends_word(*stop)) || !(std::abs(value) <= kMaxFloat)) return false;
  rest_ = {stop, static_cast<size_t>(end - stop)};
  place_line_ = line_;
  return true;
}

double Text::other_real(const char* what) {
  const std::string_view word = name(what);
  float value = 0.0f;
  if (!parse_number(word, value)) fail(in_quotes(word) + " is not a number (" + what + ")");
  if (!std::isfinite(value)) fail(in_quotes(word) + " is not finite (" + what + ")");
  return value;
}

glm::dvec3 Text::point(const char* what) {
  const double x = real(what), y = real(what);
  return {x, y, real(what)};
}

Vec3 Text::color(const char* what) {
  const glm::dvec3 rgb = point(what);
  return {static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z)};
}

long long Text::integer(const char* what) {
  const std::string_view word = name(what);
  long long value = 0;
  if (!parse_number(word, value)) fail(in_quotes(word) + " is not an integer (" + what + ")");
  return value;
}

size_t Text::count(const char* what, size_t least_numbers) {
  const long long value = integer(what);
  if (value < 0) fail("a negative number of " + std::string(what) + ": " + std::to_string(value));
  // A number takes a digit and a space; the last one may lack the space.
  if (static_cast<unsigned long long>(value) > (rest_.size() + 1) / (2 * least_numbers)) {
    fail(std::to_string(value) + " " + what + " cannot fit in the rest of the file");
  }
  return static_cast<size_t>(value);
}

void Text::skip_statement() {
  for (std::string_view next = peek(); !next.empty() && next != "}"; next = peek()) {
    if (next == "{") return skip_group();
    if (line_ != place_line_ && !begins_number(next[0])) return;
    word();
  }
}

void Text::skip_group() {
  u64 depth = 0;
  do {
    const std::string_view next = word();
    if (next.empty()) fail("the file ends inside braces");
    depth += next == "{";
    depth -= next == "}";
  } while (depth > 0);
}

}  // namespace raywalk::aff
