// The determinants of one ray and one triangle in integers: floats are integers times a power of two.
#pragma once
#include <gmpxx.h>

#include "kernels/ray.h"
#include "kernels/scene_view.h"

namespace raywalk::oracle {

/// numerator / denominator * 2^exponent; the denominator is above zero.
struct Ratio {
  mpz_class numerator, denominator;
  long exponent;
};

/// Rounded once, to nearest even; infinite beyond the floats.
float to_float(const Ratio& ratio);
/// Truncated to a double.
double to_double(const Ratio& ratio);
/// -1, 0 or 1.
int compare(const Ratio& a, const Ratio& b);
Ratio to_ratio(float a);

/// All members must be finite.
class Integers {
 public:
  Integers(const Ray& ray, const Corners& triangle);

  /// Signs of det(d, p - o, q - o) for the edge opposite to each vertex: bc, ca, ab.
  int edge_sign(u32 opposite) const;
  bool is_degenerate() const;
  /// To the plane; the line must not be parallel to it.
  Ratio distance() const;

 private:
  using Vector = mpz_class[3];
  Vector direction_, corner_[3];  // corners are seen from the origin
  long direction_exponent_, corner_exponent_;

  void normal(Vector& n) const;
};

}  // namespace raywalk::oracle
