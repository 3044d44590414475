// One vocabulary for the kinds of number a formula is evaluated with: double (a point), Pack (a
// batch), Interval (a box), Dual (a gradient) and Trend (a box with the range of its gradients).
// Formulas are templates over these names.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>

#include "base/dual.h"
#include "base/interval.h"
#include "base/trend.h"
#include "functions/noise.h"
#include "functions/pack.h"
#include "functions/simd/inline.h"

namespace durer::functions {

using std::abs, std::acos, std::acosh, std::asin, std::asinh, std::atan, std::atan2, std::atanh,
    std::ceil, std::cos, std::cosh, std::exp, std::floor, std::fmod, std::log, std::log10, std::pow,
    std::sin, std::sinh, std::sqrt, std::tan, std::tanh, std::trunc;

[[nodiscard]] inline double sqr(double a) { return a * a; }
/// Minimum and maximum as the language has them: of equals (zeros of either sign) the first; with
/// NaN the second of min, the first of max.
[[nodiscard]] inline double min(double a, double b) { return a <= b ? a : b; }
[[nodiscard]] inline double max(double a, double b) { return a < b ? b : a; }
[[nodiscard]] inline bool lt(double a, double b) { return a < b; }
[[nodiscard]] inline bool le(double a, double b) { return a <= b; }
[[nodiscard]] inline bool eq(double a, double b) { return a == b; }
[[nodiscard]] inline double where(bool m, double a, double b) { return m ? a : b; }

[[nodiscard]] inline bool all(bool m) { return m; }
[[nodiscard]] inline bool none(bool m) { return !m; }
[[nodiscard]] inline bool all(Tri m) { return !m.can_be_false; }
[[nodiscard]] inline bool none(Tri m) { return !m.can_be_true; }

[[nodiscard]] inline bool both(bool a, bool b) { return a && b; }
[[nodiscard]] inline bool either(bool a, bool b) { return a || b; }
[[nodiscard]] inline Tri both(Tri a, Tri b) { return a & b; }
[[nodiscard]] inline Tri either(Tri a, Tri b) { return a | b; }
[[nodiscard]] inline PackMask both(const PackMask& a, const PackMask& b) { return a & b; }
[[nodiscard]] inline PackMask either(const PackMask& a, const PackMask& b) { return a | b; }

template <class T>
[[nodiscard]] T truth(const decltype(lt(T(), T()))& m) {
  return where(m, T(1), T(0));
}
/// A choice whose sides are computed only where some lane, or part of a box, needs them.
template <class Mask, class A, class B>
[[nodiscard]] auto lazily(const Mask& m, A a, B b) -> decltype(a()) {
  if (all(m)) return a();
  if (none(m)) return b();
  return where(m, a(), b());
}

// ---- conversion to a 32-bit integer and back; what does not fit becomes -2^31
// --------------------
[[nodiscard]] inline double truncated32(double v) { return simd::to_int32(v); }
[[nodiscard]] inline Pack truncated32(const Pack& a) {
  return pack_detail::map(a, [](double v) { return truncated32(v); });
}
[[nodiscard]] inline Dual truncated32(const Dual& a) { return truncated32(a.v); }
[[nodiscard]] inline Interval truncated32(const Interval& a) {
  const bool fits = !a.nan && a.lo > -2147483649.0 && a.hi < 2147483648.0;
  if (fits) return {truncated32(a.lo), truncated32(a.hi)};
  return {-2147483648.0, std::max(-2147483648.0, std::min(std::trunc(a.hi), 2147483647.0))};
}

[[nodiscard]] inline Trend truncated32(const Trend& a) {
  return trend_detail::steps(truncated32(a.range()), a);
}

// ---- remainder in [0, m), for m > 0
// --------------------------------------------------------------
template <class T>
[[nodiscard]] T positive_mod(const T& a, const T& m) {
  const T r = fmod(a, m);
  return where(lt(r, T(0)), r + m, r);
}
[[nodiscard]] inline Interval positive_mod(const Interval& a, const Interval& m) {
  const Interval r = fmod(a, m);
  if (r.lo >= 0) return r;
  if (r.hi < 0) return r + m;
  const double size = std::max(std::abs(m.lo), std::abs(m.hi));
  return {m.lo > 0 ? 0.0 : -size, size, r.nan};
}

// ---- scalar noise over each kind; generator already resolved to 0..3
// ------------------------------
[[nodiscard]] inline Trend positive_mod(const Trend& a, const Trend& m) {
  const Interval p = a.range();
  const Interval q = m.range();
  const Interval v = positive_mod(p, q);
  const bool whole = q.is_point() && q.lo > 0 && trend_detail::is_constant(m) && !p.nan &&
                     std::floor(p.lo / q.lo) == std::floor(p.hi / q.lo);
  return whole ? Trend(a.all(), v) : Trend::erratic(v);
}

[[nodiscard]] Pack noise(const Pack& x, const Pack& y, const Pack& z, NoiseGenerator g);

/// If `p` is one number for the whole batch or box, that number.
[[nodiscard]] inline bool is_uniform(double p, double& value) { return value = p, true; }
[[nodiscard]] inline bool is_uniform(const Dual& p, double& value) {
  value = p.v;
  return p.d == dvec3(0.0);
}
[[nodiscard]] inline bool is_uniform(const Interval& p, double& value) {
  value = p.lo;
  return p.is_point();
}
[[nodiscard]] inline bool is_uniform(const Trend& p, double& value) {
  return is_uniform(p.range(), value);
}
[[nodiscard]] inline bool is_uniform(const Pack& p, double& value) {
  value = p.v[0];
  for (const double v : p.v) {
    if (v != value) return false;
  }
  return true;
}

/// What an evaluation needs to know beside the arguments.
struct Context {
  NoiseGenerator noise_generator = 2;  // of the scene: what f_noise3d uses
  void* scratch = nullptr;             // for functions from outside; one per thread
};

}  // namespace durer::functions
