// Products and powers of the steps.
#include "server/scene/formats/mgf/transform.h"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>
#include <string>

#include "server/scene/formats/mgf/numbers.h"
#include "server/scene/text.h"

namespace raywalk {
namespace {

using glm::dmat4;
using glm::dvec3;

constexpr double kMost = 1e30;  // coordinates are floats in the end

void check(const dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(matrix[column][row]) <= kMost)) throw std::runtime_error("the transformation leads to infinity");
    }
  }
}

dmat4 power(dmat4 base, u64 exponent) {
  dmat4 result(1.0);
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = base * result;
    if (exponent > 1) base = base * base;
    check(base);
  }
  return result;
}

/// How many numbers follow the option; -1 if there is no such option.
int numbers_after(std::string_view option) {
  if (option == "-t") return 3;
  if (option == "-rx" || option == "-ry" || option == "-rz" || option == "-s") return 1;
  if (option == "-mx" || option == "-my" || option == "-mz") return 0;
  return -1;
}

dmat4 step_of(std::string_view option, const double* numbers) {
  const dmat4 one(1.0);
  if (option == "-t") return glm::translate(one, {numbers[0], numbers[1], numbers[2]});
  const char last = option.back();
  const dvec3 axis{last == 'x' ? 1.0 : 0.0, last == 'y' ? 1.0 : 0.0, last == 'z' ? 1.0 : 0.0};
  if (option[1] == 'r') return glm::rotate(one, glm::radians(numbers[0]), axis);
  if (option[1] == 'm') return glm::scale(one, dvec3(1.0) - 2.0 * axis);
  if (numbers[0] == 0.0) throw std::runtime_error("a scale of zero");
  return glm::scale(one, dvec3(numbers[0]));
}

}  // namespace

MgfTransform::MgfTransform(std::span<const std::string_view> arguments) {
  for (size_t at = 0; at < arguments.size();) {
    const std::string_view option = arguments[at++];
    const bool array = option == "-a", repeat = option == "-i";
    const int count = array || repeat ? 1 : numbers_after(option);
    if (count < 0) throw std::runtime_error(in_quotes(option) + " is no transformation");
    if (arguments.size() - at < static_cast<size_t>(count)) {
      throw std::runtime_error(in_quotes(option) + " takes " + std::to_string(count) + " numbers");
    }
    if (array) {
      parts_.push_back({.repeats = 0, .members = mgf_count(arguments[at], 1)});
    } else if (repeat) {
      parts_.push_back({.repeats = mgf_count(arguments[at], 0)});
    } else {
      double numbers[3] = {};
      for (int i = 0; i < count; ++i) numbers[i] = mgf_number(arguments[at + i]);
      parts_.back().step = step_of(option, numbers) * parts_.back().step;
      check(parts_.back().step);
    }
    at += count;
  }
  for (Part& part : parts_) part.all = power(part.step, part.repeats);
  work_out();
}

bool MgfTransform::next() {
  for (size_t i = parts_.size(); i-- > 0;) {
    Part& part = parts_[i];
    if (part.members == 0) continue;
    if (++part.repeats < part.members) {
      part.all = part.step * part.all;
      work_out();
      return true;
    }
    part.repeats = 0;
    part.all = dmat4(1.0);
  }
  return false;
}

void MgfTransform::work_out() {
  matrix_ = dmat4(1.0);
  for (const Part& part : parts_) {
    matrix_ = part.all * matrix_;
    check(matrix_);
  }
}

}  // namespace raywalk
