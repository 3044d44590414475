#include "tracer/chi_square.h"

#include <cmath>
#include <limits>

namespace durer::tracer {
namespace {

// The share of chi-square distributed numbers beyond x. Source: Press et al., Numerical Recipes,
// "Incomplete Gamma Function"; accurate to 1e-12.
double chi_square_tail(double x, int freedom) {
  constexpr double tiny = 1e-300;
  constexpr double enough = 1e-14;
  constexpr int most = 100000;
  const double a = freedom / 2.0;
  x /= 2;
  if (x <= 0) return 1;
  const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a;
    double sum = term;
    for (int n = 1; n < most && term > sum * enough; ++n) sum += term *= x / (a + n);
    return 1 - sum * front;
  }
  double b = x + 1 - a;
  double c = 1 / tiny;
  double d = 1 / b;
  double h = d;
  for (int i = 1; i < most; ++i) {
    const double an = -i * (i - a);
    b += 2;
    d = an * d + b;
    if (std::abs(d) < tiny) d = tiny;
    c = b + an / c;
    if (std::abs(c) < tiny) c = tiny;
    d = 1 / d;
    h *= d * c;
    if (std::abs(d * c - 1) < enough) break;
  }
  return front * h;
}

}  // namespace

double chi_square_exceeded(double probability, int freedom) {
  if (probability >= 1) return 0;
  if (probability <= 0) return std::numeric_limits<double>::infinity();
  double lo = 0;
  double hi = freedom + 10;
  while (chi_square_tail(hi, freedom) > probability) hi *= 2;
  for (int i = 0; i < 200 && hi - lo > 1e-12 * hi; ++i) {
    const double mid = (lo + hi) / 2;
    (chi_square_tail(mid, freedom) > probability ? lo : hi) = mid;
  }
  return (lo + hi) / 2;
}

}  // namespace durer::tracer
