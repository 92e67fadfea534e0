// Numbers with the reason why one is refused.
#include "server/scene/formats/mgf/numbers.h"

#include <cmath>
#include <stdexcept>

#include "server/scene/text.h"

namespace raywalk {

double mgf_number(std::string_view word) {
  double value = 0.0;
  if (!parse_number(word, value)) throw std::runtime_error(in_quotes(word) + " is not a number");
  if (!std::isfinite(value)) throw std::runtime_error(in_quotes(word) + " is not finite");
  return value;
}

u64 mgf_count(std::string_view word, u64 least) {
  u64 value = 0;
  if (!parse_number(word, value) || value < least) {
    throw std::runtime_error(in_quotes(word) + " is not a whole number of at least " + std::to_string(least));
  }
  return value;
}

}  // namespace raywalk
