// Real roots in [0, 1] of polynomials in Bernstein form: the values that a Bézier curve's control
// points take. Coefficients bound the polynomial, so most questions end before any root is sought,
// and the signs at both ends are those of the first and the last coefficient, exactly: curves that
// share an end point agree about the side on which it lies.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/roots/roots.h"

namespace durer {

/// Σ b[i] · C(N, i) · x^i · (1 - x)^(N - i).
template <std::size_t N>
using Bernstein = std::array<double, N + 1>;

struct ValueAndSlope {
  double value;
  double slope;
};

/// At x, by de Casteljau's scheme, whose error does not exceed that of the coefficients.
template <std::size_t N>
[[nodiscard]] ValueAndSlope value_and_slope(Bernstein<N> b, double x) {
  for (std::size_t left = N; left > 1; --left) {
    for (std::size_t i = 0; i < left; ++i) b[i] += (b[i + 1] - b[i]) * x;
  }
  const double rise = b[1] - b[0];
  return {b[0] + rise * x, static_cast<double>(N) * rise};
}

namespace detail {

constexpr double binomial(std::size_t n, std::size_t k) {
  double b = 1;
  for (std::size_t i = 0; i < k; ++i)
    b = b * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return b;
}

struct ValueAndSlopes {
  double value;
  double slope;
  double bend;  // the slope of the slope
};

template <std::size_t N>
[[nodiscard]] ValueAndSlopes value_and_slopes(Bernstein<N> b, double x) {
  for (std::size_t left = N; left > 2; --left) {
    for (std::size_t i = 0; i < left; ++i) b[i] += (b[i + 1] - b[i]) * x;
  }
  const double first = b[1] - b[0];
  const double second = b[2] - b[1];
  const double bend = second - first;
  const double rise = first + bend * x;
  constexpr auto n = static_cast<double>(N);
  return {(b[0] + first * x) + rise * x, n * rise, n * (n - 1) * bend};
}

/// The only root of a quadratic; nothing cancels, whichever coefficient is small.
inline double only_root(double b0, double b1, double b2) {
  const double root = std::sqrt(b1 * b1 - b0 * b2);
  const bool negative_at_0 = b0 < 0;
  if ((b1 < 0) != negative_at_0 && b1 != 0) {
    const double whole = b0 - b1 + (negative_at_0 ? -root : root);
    return whole == 0 ? 0 : b0 / whole;
  }
  const double part = b1 + (negative_at_0 ? -root : root);
  return part == 0 && b2 == 0 ? 1 : part / (part - b2);
}

/// The root of a polynomial whose signs at 0 and 1 differ, and which has no other: Halley's steps,
/// halving where they would leave the bracket.
template <std::size_t N>
double only_root(const Bernstein<N>& b) {
  if constexpr (N == 1) {
    return b[0] / (b[0] - b[1]);
  } else if constexpr (N == 2) {
    return only_root(b[0], b[1], b[2]);
  } else {
    double lo = 0;
    double hi = 1;
    const bool negative_at_0 = b[0] < 0;
    double x = b[0] / (b[0] - b[N]);
    if (b[0] == 0) x = 0.5;  // it touches zero where it begins; where it changes sign is to be found
    for (int i = 0; i < 60; ++i) {  // Halley needs some 3
      const ValueAndSlopes at = value_and_slopes<N>(b, x);
      if (at.value == 0) return x;
      ((at.value < 0) == negative_at_0 ? lo : hi) = x;
      const double next =
          x - 2 * at.value * at.slope / (2 * at.slope * at.slope - at.value * at.bend);
      if (next >= lo && next <= hi) {
        // The error is about the cube of the step: one so small was the last that mattered.
        const double step = std::abs(next - x);
        x = next;
        if (step <= 1e-6) break;
      } else {
        x = 0.5 * (lo + hi);
        if (hi - lo <= 1e-16) break;
      }
    }
    return x;
  }
}

template <std::size_t N>
std::size_t variations(const Bernstein<N>& b) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < N; ++i) n += (b[i] < 0) != (b[i + 1] < 0) ? 1 : 0;
  return n;
}

/// The part of b over [0, ½]; leaves that over [½, 1] in b.
template <std::size_t N>
Bernstein<N> split(Bernstein<N>& b) {
  Bernstein<N> left{};
  for (std::size_t k = 0; k <= N; ++k) {
    left[k] = b[0];
    for (std::size_t i = 0; i + k < N; ++i) b[i] = 0.5 * (b[i] + b[i + 1]);
  }
  return left;
}

template <std::size_t N>
void add_sign_changes(const Bernstein<N>& b, double lo, double size, Roots<N>& out) {
  // There are as many roots as variations, or fewer by an even number [Descartes].
  const std::size_t n = variations<N>(b);
  if (n == 0) return;
  if (n == 1) {
    if (out.count < N) out.add(lo + size * only_root<N>(b));
    return;
  }
  if (size < 1e-12) {  // a root of higher order, as good as
    if ((b[0] < 0) != (b[N] < 0) && out.count < N) out.add(lo + 0.5 * size);
    return;
  }
  Bernstein<N> right = b;
  const Bernstein<N> left = split<N>(right);
  add_sign_changes<N>(left, lo, 0.5 * size, out);
  add_sign_changes<N>(right, lo + 0.5 * size, 0.5 * size, out);
}

template <std::size_t N>
bool has_sign_change(const Bernstein<N>& b, double size) {
  if ((b[0] < 0) != (b[N] < 0)) return true;
  if (variations<N>(b) == 0 || size < 1e-12) return false;
  Bernstein<N> right = b;
  const Bernstein<N> left = split<N>(right);
  return has_sign_change<N>(left, 0.5 * size) || has_sign_change<N>(right, 0.5 * size);
}

/// By what the product of coefficients i and j counts.
template <std::size_t N, std::size_t M>
inline constexpr auto product_weights = [] {
  std::array<std::array<double, M + 1>, N + 1> w{};
  for (std::size_t i = 0; i <= N; ++i) {
    for (std::size_t j = 0; j <= M; ++j) {
      w[i][j] = binomial(N, i) * binomial(M, j) / binomial(N + M, i + j);
    }
  }
  return w;
}();
}  // namespace detail

/// The product of two polynomials.
template <std::size_t N, std::size_t M>
[[nodiscard]] constexpr Bernstein<N + M> product(const Bernstein<N>& a, const Bernstein<M>& b) {
  Bernstein<N + M> c{};
  for (std::size_t i = 0; i <= N; ++i) {
    for (std::size_t j = 0; j <= M; ++j) {
      c[i + j] += detail::product_weights<N, M>[i][j] * (a[i] * b[j]);
    }
  }
  return c;
}

template <std::size_t N>
[[nodiscard]] constexpr Bernstein<N - 1> derivative(const Bernstein<N>& b) {
  Bernstein<N - 1> d{};
  for (std::size_t i = 0; i < N; ++i) d[i] = static_cast<double>(N) * (b[i + 1] - b[i]);
  return d;
}

/// The same polynomial, by more coefficients.
template <std::size_t M, std::size_t N>
[[nodiscard]] constexpr Bernstein<M> raised(const Bernstein<N>& a) {
  if constexpr (M == N) {
    return a;
  } else {
    Bernstein<M - N> one{};
    one.fill(1);
    return product<N, M - N>(a, one);
  }
}

/// The places in [0, 1] where the sign changes, ascending; 0 counts as positive, and places where
/// the curve only touches zero are none. Their number is odd exactly if the signs of the first and
/// the last coefficient differ.
template <std::size_t N>
[[nodiscard]] Roots<N> sign_changes(const Bernstein<N>& b) {
  Roots<N> out;
  detail::add_sign_changes<N>(b, 0, 1, out);
  return out;
}

/// True if there is any such place.
template <std::size_t N>
[[nodiscard]] bool has_sign_change(const Bernstein<N>& b) {
  return detail::has_sign_change<N>(b, 1);
}

/// The coefficients over [lo, hi] of the polynomial with coefficients b over [0, 1].
template <std::size_t N>
[[nodiscard]] Bernstein<N> restricted(Bernstein<N> b, double lo, double hi) {
  for (std::size_t k = 1; k <= N; ++k) {  // the part right of lo
    for (std::size_t i = 0; i + k <= N; ++i) b[i] += (b[i + 1] - b[i]) * lo;
  }
  const double x = lo < 1 ? (hi - lo) / (1 - lo) : 0;
  for (std::size_t k = 1; k <= N; ++k) {  // of which the part left of x
    for (std::size_t i = N; i >= k; --i) b[i] = b[i - 1] + (b[i] - b[i - 1]) * x;
  }
  return b;
}

}  // namespace durer
