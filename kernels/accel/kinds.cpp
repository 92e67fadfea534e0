// The kinds of structures, and the check of options given for one.
#include <cmath>
#include <stdexcept>

#include "kernels/accel/brute/kind.h"
#include "kernels/accel/bvh/build.h"
#include "kernels/accel/grid/kind.h"
#include "kernels/accel/kdtree/kind.h"
#include "kernels/accel/kind.h"

namespace raywalk {
namespace {

void check(const Kind& kind, const Option& option, double value) {
  const std::string where = std::string(kind.name) + " option " + std::string(option.name);
  const double max = option.choices.empty() ? option.max : static_cast<double>(option.choices.size()) - 1;
  const double min = option.choices.empty() ? option.min : 0;
  if (!(value >= min && value <= max))
    throw std::invalid_argument(where + ": " + std::to_string(value) + " is outside [" + std::to_string(min) + ", " +
                                std::to_string(max) + "]");
  const bool whole = option.integer || !option.choices.empty();
  if (whole && value != std::floor(value))
    throw std::invalid_argument(where + ": " + std::to_string(value) + " is not a whole number");
  if (option.step > 0 && std::fmod(value, option.step) != 0)
    throw std::invalid_argument(where + ": " + std::to_string(value) + " is not a multiple of " +
                                std::to_string(option.step));
}

}  // namespace

OptionValues with_defaults(const Kind& kind, const OptionValues& given) {
  OptionValues complete;
  for (const Option& option : kind.options) complete.emplace(option.name, option.default_value);
  for (const auto& [name, value] : given) {
    const auto known = complete.find(name);
    if (known == complete.end()) throw std::invalid_argument(std::string(kind.name) + " has no option " + name);
    known->second = value;
  }
  for (const Option& option : kind.options) check(kind, option, complete.find(option.name)->second);
  return complete;
}

const std::vector<const Kind*>& kinds() {
  static const std::vector<const Kind*> all = {&brute::kind(), &grid::kind(), &kdtree::kind(), &bvh::kind()};
  return all;
}

}  // namespace raywalk
