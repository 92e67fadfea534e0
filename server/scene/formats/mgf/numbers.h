// Arguments of MGF's statements as numbers.
#pragma once
#include <string_view>

#include "kernels/platform.h"

namespace raywalk {

/// Throws std::runtime_error if the word is no finite number.
double mgf_number(std::string_view word);
/// Throws std::runtime_error if the word is no whole number of at least `least`.
u64 mgf_count(std::string_view word, u64 least);

}  // namespace raywalk
