// Sign changes of polynomials whose degree is known at run time only, by the method of
// polynomial.h.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/roots/polynomial.h"
#include "base/roots/roots.h"

namespace durer {

/// The language's greatest degree (objects §12.3).
inline constexpr std::size_t max_degree = 35;

/// Coefficients c[0] … c[degree], the leading one first.
struct AnyPolynomial {
  std::array<double, max_degree + 1> c{};
  std::size_t degree = 0;

  [[nodiscard]] double operator()(double x) const {
    double y = c[0];
    for (std::size_t i = 1; i <= degree; ++i) y = y * x + c[i];
    return y;
  }
  [[nodiscard]] AnyPolynomial derivative() const {
    AnyPolynomial d;
    d.degree = degree - 1;
    for (std::size_t i = 0; i < degree; ++i) d.c[i] = c[i] * static_cast<double>(degree - i);
    return d;
  }
  /// Drops leading zeros; false if a constant is left.
  bool trim() {
    std::size_t zeros = 0;
    while (zeros < degree && c[zeros] == 0) ++zeros;
    for (std::size_t i = 0; i + zeros <= degree; ++i) c[i] = c[i + zeros];
    degree -= zeros;
    return degree > 0;
  }
  /// All roots lie in (-r, r) [Cauchy].
  [[nodiscard]] double root_bound() const {
    double largest = 0;
    for (std::size_t i = 1; i <= degree; ++i) largest = std::fmax(largest, std::abs(c[i] / c[0]));
    return 1 + largest;
  }
};

/// The places in (lo, hi) where the sign changes, ascending; see sign_changes<N>.
[[nodiscard]] Roots<max_degree> sign_changes(const AnyPolynomial& p, double lo, double hi);

}  // namespace durer
