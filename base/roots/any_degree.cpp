#include "base/roots/any_degree.h"

namespace durer {
namespace {

template <std::size_t N>
Roots<max_degree> fixed(const AnyPolynomial& p, double lo, double hi) {
  Polynomial<N> c{};
  for (std::size_t i = 0; i <= N; ++i) c[i] = p.c[i];
  Roots<max_degree> out;
  for (const double x : sign_changes<N>(c, lo, hi)) out.add(x);
  return out;
}

/// The root between a and b, where the signs differ and no extremum lies.
double bracketed(const AnyPolynomial& p, const AnyPolynomial& slope, double a, double b,
                 bool negative_at_a) {
  double x = 0.5 * (a + b);
  for (int i = 0; i < 100; ++i) {
    const double y = p(x);
    if (y == 0) return x;
    ((y < 0) == negative_at_a ? a : b) = x;
    double next = x - y / slope(x);
    if (!(next >= a && next <= b)) next = 0.5 * (a + b);
    const double step = std::abs(next - x);
    x = next;
    if (step <= 1e-15 * std::abs(x) || step <= 1e-18 * (b - a)) break;
  }
  return x;
}

}  // namespace

Roots<max_degree> sign_changes(const AnyPolynomial& p, double lo, double hi) {
  switch (p.degree) {
    case 0: return {};
    case 1: {
      Roots<max_degree> one;
      const double x = -p.c[1] / p.c[0];
      if (x > lo && x < hi) one.add(x);
      return one;
    }
    case 2: return fixed<2>(p, lo, hi);
    case 3: return fixed<3>(p, lo, hi);
    case 4: return fixed<4>(p, lo, hi);
    default: break;
  }
  const AnyPolynomial slope = p.derivative();
  const Roots<max_degree> extrema = sign_changes(slope, lo, hi);
  Roots<max_degree> roots;
  double a = lo;
  bool negative = p(lo) < 0;
  for (std::size_t i = 0; i <= extrema.count; ++i) {
    const double b = i < extrema.count ? extrema.values[i] : hi;
    const bool negative_at_b = p(b) < 0;
    if (negative != negative_at_b) roots.add(bracketed(p, slope, a, b, negative));
    a = b;
    negative = negative_at_b;
  }
  return roots;
}

}  // namespace durer
