#include "tracer/primitives/julia_orbit.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <type_traits>

namespace durer::tracer {
namespace {

using Complex = std::complex<double>;

Four squared(Four q) {
  return {q.x * q.x - q.y * q.y - q.z * q.z - q.w * q.w, 2 * q.x * q.y, 2 * q.x * q.z,
          2 * q.x * q.w};
}
Four cubed(Four q) {
  const double d = q.y * q.y + q.z * q.z + q.w * q.w;
  const double f = 3 * q.x * q.x - d;
  return {q.x * (q.x * q.x - 3 * d), f * q.y, f * q.z, f * q.w};
}

/// The product of hypercomplex numbers, which commutes.
Four times(Four a, Four b) {
  return {
      a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
      a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}

/// A hypercomplex number is a pair of complex ones, on which functions act one by one.
template <typename F>
Four on_both(Four q, F&& f) {
  const Complex a = f(Complex(q.x - q.w, q.y + q.z));
  const Complex b = f(Complex(q.x + q.w, q.y - q.z));
  return {0.5 * (a.real() + b.real()), 0.5 * (a.imag() + b.imag()), 0.5 * (a.imag() - b.imag()),
          0.5 * (b.real() - a.real())};
}

const Complex i1(0, 1);

Complex tangent(Complex z) {
  const double x = 2 * z.real();
  const double y = 2 * z.imag();
  const double d = std::cos(x) + std::cosh(y);
  return {std::sin(x) / d, std::sinh(y) / d};
}
Complex hyperbolic_tangent(Complex z) {
  const double x = 2 * z.real();
  const double y = 2 * z.imag();
  const double d = std::cosh(x) + std::cos(y);
  return {std::sinh(x) / d, std::sin(y) / d};
}
Complex to_power(Complex z, Complex p) {
  if (z == 0.0) return 0;
  const Complex e = p * std::log(z);
  return e.real() < -690 ? Complex(0) : std::exp(e);
}

Complex apply(JuliaFunction f, Complex z, Complex power) {
  using F = JuliaFunction;
  switch (f) {
    case F::exp: return std::exp(z);
    case F::reciprocal: return 1.0 / z;
    case F::sin: return std::sin(z);
    case F::asin: return -i1 * std::log(i1 * z + std::sqrt(1.0 - z * z));
    case F::sinh: return std::sinh(z);
    case F::asinh: return std::log(z + std::sqrt(z * z + 1.0));
    case F::cos: return std::cos(z);
    case F::acos: return -i1 * std::log(z + std::sqrt(z * z - 1.0));
    case F::cosh: return std::cosh(z);
    case F::acosh: return std::log(z + std::sqrt(z * z - 1.0));
    case F::tan: return tangent(z);
    case F::atan: return 0.5 * i1 * std::log((1.0 - i1 * z) / (1.0 + i1 * z));
    case F::tanh: return hyperbolic_tangent(z);
    case F::atanh: return 0.5 * std::log((1.0 + z) / (1.0 - z));
    case F::ln: return std::log(z);
    case F::pwr: return to_power(z, power);
    default: return z * z;
  }
}

/// The product of p with the conjugate axes, as the oracle takes it for a gradient.
dvec3 gradient(Four p, Four q) {
  return {p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w,
          -p.y * q.x + p.x * q.y - p.w * q.z + p.z * q.w,
          -p.z * q.x - p.w * q.y + p.x * q.z + p.y * q.w};
}

/// k to the power of -(i + 1).
template <int k>
double shrunk(std::uint32_t i) {
  static constexpr std::array<double, 64> known = [] {
    std::array<double, 64> all{};
    double scale = 1;
    for (double& v : all) v = scale /= k;
    return all;
  }();
  return i < known.size() ? known[i] : std::pow(k, -1.0 - i);
}
/// A number that is not less than the logarithm of v > 0.
double above_log(double v) {
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(v) >> 52) - 1023;
  return (exponent + 1) * std::numbers::ln2;
}

}  // namespace

Four JuliaSet::next(Four q) const {
  if (!hypercomplex) return (function == JuliaFunction::sqr ? squared(q) : cubed(q)) + c;
  // The cube of hypercomplex numbers is a square in the oracle.
  if (function == JuliaFunction::sqr || function == JuliaFunction::cube) return times(q, q) + c;
  return on_both(q, [this](Complex z) { return apply(function, z, power); }) + c;
}

/// By what the derivative grows in one step, as the oracle has it.
Four JuliaSet::factor(Four q) const {
  switch (function) {
    case JuliaFunction::sqr:
    case JuliaFunction::cube: return q;
    case JuliaFunction::reciprocal: return on_both(q, [](Complex z) { return -1.0 / (z * z); });
    default: return on_both(q, [this](Complex z) { return apply(function, z, power); });
  }
}

// So the oracle does: its quick loop for functions begins with y in the place of z.
Four JuliaSet::start(dvec3 p) const {
  Four q = at(p);
  if (hypercomplex && function != JuliaFunction::sqr && function != JuliaFunction::cube &&
      function != JuliaFunction::reciprocal) {
    q.z = q.y;
  }
  return q;
}

bool JuliaSet::contains(dvec3 p) const {
  if (is_polynomial()) {
    return with_orbit(*this, p.x, p.y, p.z, [&](auto q, auto step) {
      for (std::uint32_t i = 0; i < iterations; ++i) {
        if (q.norm2() > escape2) return false;
        step(q);
      }
      return true;
    });
  }
  Four q = start(p);
  for (std::uint32_t i = 0; i < iterations; ++i) {
    if (norm2(q) > escape2) return false;
    q = next(q);
  }
  return true;
}

JuliaSet::Look JuliaSet::look(dvec3 p, dvec3 d) const {
  if (!is_polynomial()) return look_function(at(p), d);
  return with_orbit(*this, p.x, p.y, p.z, [&](auto q, auto step) {
    auto product = q.first_product();
    for (std::uint32_t i = 0; i < iterations; ++i) {
      const double n2 = q.norm2();
      if (n2 > escape2) {
        if constexpr (std::is_same_v<decltype(q), QuaternionOrbit<double>>) {
          return Look{false, step_quaternion(i, product, n2)};
        } else {
          return Look{false, step_hypercomplex(i, four(product), four(q), d)};
        }
      }
      product = q.multiplied(product, n2, i);
      step(q);
    }
    return Look{true, smallest_step};
  });
}

JuliaSet::Look JuliaSet::look_function(Four q, dvec3 d) const {
  Four product = q;
  for (std::uint32_t i = 0; i < iterations; ++i) {
    if (norm2(q) > escape2) return {false, step_hypercomplex(i, product, q, d)};
    if (i > 0) product = times(product, factor(q));
    q = next(q);
  }
  return {true, smallest_step};
}

double JuliaSet::step_quaternion(std::uint32_t i, double product2, double n2) const {
  const double scale = function == JuliaFunction::sqr ? shrunk<2>(i) : shrunk<3>(i);
  // Mostly a bound of the logarithm tells that the step would be too small.
  const double longest = scale * above_log(n2);
  if (longest * longest < 0.999 * smallest_step * smallest_step * product2) return smallest_step;
  return std::max(scale / std::sqrt(product2) * std::log(n2), smallest_step);
}

double JuliaSet::step_hypercomplex(std::uint32_t i, Four product, Four q, dvec3 d) const {
  const double n2 = norm2(q);
  dvec3 g = gradient(product, q);
  if (function == JuliaFunction::sqr) g *= i == 0 ? 2 : std::ldexp(1.0, static_cast<int>(i));
  const double along = glm::dot(g, d);
  const double slope = -2 * along;
  if (!(along < -1e-8)) return smallest_step;
  const bool fair = n2 > smallest_step * slope && n2 < 30 * smallest_step * slope;
  return fair ? n2 / slope : smallest_step;
}

dvec3 JuliaSet::normal_quaternion(Four q) const {
  std::array<Four, 3> t = {Four{1, 0, 0, 0}, Four{0, 1, 0, 0}, Four{0, 0, 1, 0}};
  for (std::uint32_t i = 0; i < iterations; ++i) {
    const double d = q.y * q.y + q.z * q.z + q.w * q.w;
    for (Four& e : t) {
      const double s = e.y * q.y + e.z * q.z + e.w * q.w;
      if (function == JuliaFunction::sqr) {
        e = {e.x * q.x - s, e.x * q.y + e.y * q.x, e.x * q.z + e.z * q.x, e.x * q.w + e.w * q.x};
      } else {
        const double m = 6 * q.x * e.x - 2 * s;
        const double f = 3 * q.x * q.x - d;
        e = {3 * (e.x * (q.x * q.x - d) - q.x * 2 * s), e.y * f + q.y * m, e.z * f + q.z * m,
             e.w * f + q.w * m};
      }
    }
    q = next(q);
  }
  const auto along = [q](Four e) { return e.x * q.x + e.y * q.y + e.z * q.z + e.w * q.w; };
  return {along(t[0]), along(t[1]), along(t[2])};
}

dvec3 JuliaSet::normal(dvec3 p) const {
  Four q = start(p);
  dvec3 n;
  if (!hypercomplex) {
    n = normal_quaternion(q);
  } else {
    Four product = q;
    for (std::uint32_t i = 0; i < iterations; ++i) {
      if (i > 0) product = times(product, factor(q));
      q = next(q);
    }
    n = gradient(product, q);
  }
  const double length = glm::length(n);
  return std::isfinite(length) && length > 0 ? n / length : dvec3(1, 0, 0);
}

}  // namespace durer::tracer
