// The smooth curve through a row of points or numbers.
#pragma once
#include <cstddef>

namespace raywalk {

/// Uniform Catmull-Rom from value(i) to value(i + 1) of `count`, u in [0, 1]; beyond its ends the row goes straight on.
template <class ValueAt>
auto catmull_rom(ValueAt value, std::size_t count, std::size_t i, float u) {
  const auto b = value(i), c = value(i + 1);
  const auto a = i > 0 ? value(i - 1) : 2.0f * b - c, d = i + 2 < count ? value(i + 2) : 2.0f * c - b;
  return b + 0.5f * u * (c - a + u * (2.0f * a - 5.0f * b + 4.0f * c - d + u * (3.0f * (b - c) + d - a)));
}

}  // namespace raywalk
