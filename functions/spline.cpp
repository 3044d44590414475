#include "functions/spline.h"

#include <algorithm>
#include <cassert>

namespace durer::functions {
namespace {

bool key_below(const Spline::Entry& e, double key) { return e.key < key; }

}  // namespace

Spline::Spline(SplineKind kind, int dimension, std::span<const Entry> entries)
    : kind_(kind), dimension_(dimension) {
  assert(!entries.empty() && dimension >= 2 && dimension <= 5);
  for (const Entry& entry : entries) insert(entry);
  solve_natural();
}

void Spline::insert(const Entry& entry) {
  const auto place = std::lower_bound(entries_.begin(), entries_.end(), entry.key, key_below);
  if (place == entries_.end() || place->key != entry.key) {
    entries_.insert(place, entry);
  } else if (entries_.size() < 2 || place + 1 != entries_.end()) {
    place->value = entry.value;
  }
}

/// Tridiagonal system with zero second derivatives at both ends, by elimination.
void Spline::solve_natural() {
  const std::size_t n = entries_.size();
  second_derivatives_.assign(n, SplineValue{});
  if (n < 3) return;
  const std::size_t m = n - 1;
  const auto h = [&](std::size_t k) { return entries_[k + 1].key - entries_[k].key; };
  std::vector<double> u(n);
  std::vector<double> w(n);
  for (std::size_t c = 0; c < 5; ++c) {
    const auto b = [&](std::size_t k) {
      return (entries_[k + 1].value[c] - entries_[k].value[c]) / h(k);
    };
    u[1] = 2 * (h(0) + h(1));
    w[1] = 6 * (b(1) - b(0));
    for (std::size_t k = 2; k < m; ++k) {
      u[k] = 2 * (h(k) + h(k - 1)) - h(k - 1) * h(k - 1) / u[k - 1];
      w[k] = 6 * (b(k) - b(k - 1)) - h(k - 1) * w[k - 1] / u[k - 1];
    }
    for (std::size_t k = m - 1; k >= 1; --k) {
      second_derivatives_[k][c] = (w[k] - h(k) * second_derivatives_[k + 1][c]) / u[k];
    }
  }
}

SplineValue Spline::at(double t, SplineKind as) const {
  const std::size_t last = entries_.size() - 1;
  if (last == 0) return entries_[0].value;

  // The smallest i with t <= key[i]; last + 1 from the last key on.
  const auto above = std::lower_bound(entries_.begin(), entries_.end(), t, key_below);
  const auto i =
      t >= entries_[last].key ? last + 1 : static_cast<std::size_t>(above - entries_.begin());
  if (as != SplineKind::cubic) {
    if (i == 0) return entries_.front().value;
    if (i > last) return entries_.back().value;
  }
  SplineValue r{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
    switch (as) {
      case SplineKind::linear: r[c] = linear(t, i, c); break;
      case SplineKind::quadratic: r[c] = quadratic(t, i, c); break;
      case SplineKind::cubic: r[c] = cubic(t, i, c); break;
      case SplineKind::natural: r[c] = natural(t, i, c); break;
    }
  }
  return r;
}

double Spline::linear(double t, std::size_t i, std::size_t c) const {
  const Entry& a = entries_[i - 1];
  const Entry& b = entries_[i];
  return (t - a.key) * (b.value[c] - a.value[c]) / (b.key - a.key) + a.value[c];
}

/// The parabola through the two entries before and the one after `t` (the first three at the
/// start).
double Spline::quadratic(double t, std::size_t i, std::size_t c) const {
  if (entries_.size() == 2) return linear(t, i, c);
  const std::size_t first = i >= 2 ? i - 2 : 0;
  const double ta = entries_[first].key;
  const double tb = entries_[first + 1].key;
  const double tc = entries_[first + 2].key;
  const double va = entries_[first].value[c];
  const double vb = entries_[first + 1].value[c];
  const double vc = entries_[first + 2].value[c];
  const double n = (tb - ta) * (tc - ta) * (tc - tb);
  const double A = (-tb * va + tc * va + ta * vb - tc * vb - ta * vc + tb * vc) / n;
  const double B =
      (tb * tb * va - tc * tc * va - ta * ta * vb + tc * tc * vb + ta * ta * vc - tb * tb * vc) / n;
  const double C = (-tb * tb * tc * va + tb * tc * tc * va + ta * ta * tc * vb - ta * tc * tc * vb -
                    ta * ta * tb * vc + ta * tb * tb * vc) /
                   n;
  return (A * t + B) * t + C;
}

/// Catmull-Rom with keys at any distance.
double Spline::cubic(double t, std::size_t i, std::size_t c) const {
  const std::size_t last = entries_.size() - 1;
  const auto v = [&](std::size_t k) { return entries_[k].value[c]; };
  const auto key = [&](std::size_t k) { return entries_[k].key; };
  if (last == 1) return (v(0) + v(1)) / 2;
  if (i < 2) return v(1);
  if (i >= last) return v(last - 1);
  const std::size_t k = i - 1;
  const double dt = key(k + 1) - key(k);
  const double u = (t - key(k)) / dt;
  const double g = (v(k + 1) - v(k)) / dt;
  const double d0 = 0.5 * ((v(k) - v(k - 1)) / (key(k) - key(k - 1)) + g) * dt;
  const double d1 = 0.5 * ((v(k + 2) - v(k + 1)) / (key(k + 2) - key(k + 1)) + g) * dt;
  // Powers written out: so the last bits are the oracle's.
  return (2 * u * u * u - 3 * u * u + 1) * v(k) + (-2 * u * u * u + 3 * u * u) * v(k + 1) +
         (u * u * u - 2 * u * u + u) * d0 + (u * u * u - u * u) * d1;
}

double Spline::natural(double t, std::size_t i, std::size_t c) const {
  const std::size_t k = i - 1;
  const double h = entries_[k + 1].key - entries_[k].key;
  const double d = t - entries_[k].key;
  const double z0 = second_derivatives_[k][c];
  const double z1 = second_derivatives_[k + 1][c];
  double s = z0 / 2 + d * (z1 - z0) / (6 * h);
  s = -(h / 6) * (z1 + 2 * z0) + (entries_[k + 1].value[c] - entries_[k].value[c]) / h + d * s;
  return entries_[k].value[c] + d * s;
}

}  // namespace durer::functions
