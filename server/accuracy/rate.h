// Rates of rare events.
#pragma once
#include <algorithm>
#include <cmath>

#include "kernels/platform.h"

namespace raywalk {

/// Events per million; 0 of nothing.
inline double per_million(double count, u64 of) {
  return of == 0 ? 0.0 : 1e6 * count / static_cast<double>(of);
}

/// Upper end of the one-sided 95 % interval of a rate, in events per million, when `count` of `of` were seen: 3/N when
/// none was, at most 1e6.
inline double upper95_ppm(u64 count, u64 of) {
  if (count == 0) return std::min(per_million(3.0, of), 1e6);
  // Wilson and Hilferty's approximation of the Poisson limit.
  const double k = static_cast<double>(count) + 1.0;
  const double root = 1.0 - 1.0 / (9.0 * k) + 1.645 / (3.0 * std::sqrt(k));
  return std::min(per_million(k * root * root * root, of), 1e6);
}

}  // namespace raywalk
