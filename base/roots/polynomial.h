// Real roots of a polynomial in an interval, each found between two neighbouring extrema
// [Yuksel, "High-Performance Polynomial Root Finding for Graphics", HPG 2022].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/roots/quadratic.h"

namespace durer {

/// Coefficients of degree N, the leading one first.
template <std::size_t N>
using Polynomial = std::array<double, N + 1>;

template <std::size_t N>
[[nodiscard]] double evaluate(const Polynomial<N>& c, double x) {
  double y = c[0];
  for (std::size_t i = 1; i <= N; ++i) y = y * x + c[i];
  return y;
}

template <std::size_t N>
[[nodiscard]] Polynomial<N - 1> derivative(const Polynomial<N>& c) {
  Polynomial<N - 1> d{};
  for (std::size_t i = 0; i < N; ++i) d[i] = c[i] * static_cast<double>(N - i);
  return d;
}

/// The root between a and b, where the polynomial has different signs and no extremum: Newton
/// steps, halving where they would leave the bracket. Accurate to the last bits of evaluation.
template <std::size_t N>
[[nodiscard]] double bracketed_root(const Polynomial<N>& c, const Polynomial<N - 1>& slope,
                                    double a, double b, bool negative_at_a) {
  double x = 0.5 * (a + b);
  for (int i = 0; i < 100; ++i) {  // halving alone needs 60; Newton some 6
    const double y = evaluate<N>(c, x);
    if (y == 0) return x;
    ((y < 0) == negative_at_a ? a : b) = x;
    double next = x - y / evaluate<N - 1>(slope, x);
    if (!(next >= a && next <= b)) next = 0.5 * (a + b);
    const double step = std::abs(next - x);
    x = next;
    if (step <= 1e-15 * std::abs(x) || step <= 1e-18 * (b - a)) break;
  }
  return x;
}

/// How often the polynomial can change its sign in (lo, hi): so often, or less by an even number
/// [Descartes, for the coefficients in Bernstein form].
template <std::size_t N>
[[nodiscard]] int most_sign_changes(Polynomial<N> c, double lo, double hi) {
  // About lo, in units of the interval: c[N - i] · u^i.
  double unit = 1;
  for (std::size_t k = 0; k <= N; ++k) {
    for (std::size_t i = 1; i + k <= N; ++i) c[i] += c[i - 1] * lo;
    c[N - k] *= unit;
    unit *= hi - lo;
  }
  // Coefficient j in Bernstein form is the sum of C(j, i) / C(N, i) · c[N - i].
  double binomial = 1;
  for (std::size_t i = 0; i <= N; ++i) {
    c[N - i] /= binomial;
    binomial = binomial * static_cast<double>(N - i) / static_cast<double>(i + 1);
  }
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t i = 0; i < N - k; ++i) c[i] += c[i + 1];
  }
  int changes = 0;
  for (std::size_t i = 0; i < N; ++i) changes += (c[i] < 0) != (c[i + 1] < 0) ? 1 : 0;
  return changes;
}

/// The places in (lo, hi) where the sign of the polynomial changes, ascending. Roots of even
/// multiplicity are none. The count is even exactly if the signs at both ends agree, whatever
/// rounding does: closed surfaces are never entered without being left.
template <std::size_t N>
[[nodiscard]] Roots<N> sign_changes(const Polynomial<N>& c, double lo, double hi) {
  if constexpr (N == 2) {
    Roots<2> inside;
    for (const double x : quadratic_roots(c[0], c[1], c[2])) {
      if (x > lo && x < hi) inside.add(x);
    }
    return inside;
  } else {
    const Polynomial<N - 1> slope = derivative<N>(c);
    // Most intervals hold no root or one, which needs no extrema.
    const int most = most_sign_changes<N>(c, lo, hi);
    if (most <= 1) {
      const bool negative_at_lo = evaluate<N>(c, lo) < 0;
      const bool changes = negative_at_lo != (evaluate<N>(c, hi) < 0);
      Roots<N> single;
      if (changes && most == 1) single.add(bracketed_root<N>(c, slope, lo, hi, negative_at_lo));
      if (changes == (most == 1)) return single;
    }
    const Roots<N - 1> extrema = sign_changes<N - 1>(slope, lo, hi);
    Roots<N> roots;
    double a = lo;
    bool negative = evaluate<N>(c, lo) < 0;
    for (std::size_t i = 0; i <= extrema.count; ++i) {
      const double b = i < extrema.count ? extrema.values[i] : hi;
      const bool negative_at_b = evaluate<N>(c, b) < 0;
      if (negative != negative_at_b) roots.add(bracketed_root<N>(c, slope, a, b, negative));
      a = b;
      negative = negative_at_b;
    }
    return roots;
  }
}

/// Sign changes of a x³ + b x² + c x + d (leading coefficient first) in (lo, hi).
[[nodiscard]] inline Roots<3> cubic_roots(const Polynomial<3>& c, double lo, double hi) {
  return sign_changes<3>(c, lo, hi);
}
/// Sign changes of a quartic (leading coefficient first) in (lo, hi).
[[nodiscard]] inline Roots<4> quartic_roots(const Polynomial<4>& c, double lo, double hi) {
  return sign_changes<4>(c, lo, hi);
}

}  // namespace durer
