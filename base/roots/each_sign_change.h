// Roots one after another, for those who may need the first alone.
#pragma once

#include "base/roots/polynomial.h"

namespace durer {

/// Calls f(x) with what sign_changes() finds, ascending, to the same bits, until it returns false.
/// No root behind that one is worked out, nor the extrema beyond it. False if it was stopped.
template <std::size_t N, typename F>
bool each_sign_change(const Polynomial<N>& c, double lo, double hi, F&& f) {
  if constexpr (N == 2) {
    for (const double x : quadratic_roots(c[0], c[1], c[2])) {
      if (x > lo && x < hi && !f(x)) return false;
    }
    return true;
  } else {
    const Polynomial<N - 1> slope = derivative<N>(c);
    bool negative = evaluate<N>(c, lo) < 0;
    const int most = most_sign_changes<N>(c, lo, hi);
    if (most <= 1) {
      const bool changes = negative != (evaluate<N>(c, hi) < 0);
      if (changes == (most == 1)) {
        return !changes || f(bracketed_root<N>(c, slope, lo, hi, negative));
      }
    }
    double a = lo;
    const auto piece = [&](double b) {
      const bool negative_at_b = evaluate<N>(c, b) < 0;
      const bool going = negative == negative_at_b || f(bracketed_root<N>(c, slope, a, b, negative));
      a = b;
      negative = negative_at_b;
      return going;
    };
    return each_sign_change<N - 1>(slope, lo, hi, piece) && piece(hi);
  }
}

}  // namespace durer
