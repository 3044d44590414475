#pragma once

#include <cmath>
#include <utility>

#include "base/roots/roots.h"

namespace durer {

/// Real roots of a x² + b x + c. None for a double root or for no root; a may be 0.
/// Accuracy: neither root suffers from cancellation in -b ± √D.
[[nodiscard]] inline Roots<2> quadratic_roots(double a, double b, double c) {
  Roots<2> roots;
  if (a == 0) {
    if (b != 0) roots.add(-c / b);
    return roots;
  }
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant > 0)) return roots;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double x1 = q / a;
  double x2 = c / q;  // q != 0: it is at least half the root of a positive number
  if (x1 > x2) std::swap(x1, x2);
  roots.add(x1);
  roots.add(x2);
  return roots;
}

}  // namespace durer
