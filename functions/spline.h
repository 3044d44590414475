// Splines of the language: values between keyed points (language §5.2).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace durer::functions {

enum class SplineKind : std::uint8_t { linear, quadratic, cubic, natural };

/// Up to five components; those beyond the spline's dimension are 0.
using SplineValue = std::array<double, 5>;

/// Immutable; copies of entries make a spline that extends another.
class Spline {
 public:
  struct Entry {
    double key = 0;
    SplineValue value{};
  };

  /// `entries` (at least one) as they were written: sorted here by key. An equal key replaces the
  /// value, except that a repetition of the largest key so far is ignored once there are two
  /// entries. `dimension` 2 to 5 is the length of the longest entry.
  Spline(SplineKind kind, int dimension, std::span<const Entry> entries);

  [[nodiscard]] SplineKind kind() const { return kind_; }
  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

  /// Value at `t`, or that of the same entries as another kind. Constant outside the keys (cubic:
  /// outside the second and the last but one key).
  [[nodiscard]] SplineValue at(double t) const { return at(t, kind_); }
  [[nodiscard]] SplineValue at(double t, SplineKind as) const;

 private:
  void insert(const Entry& entry);
  void solve_natural();
  [[nodiscard]] double linear(double t, std::size_t i, std::size_t c) const;
  [[nodiscard]] double quadratic(double t, std::size_t i, std::size_t c) const;
  [[nodiscard]] double cubic(double t, std::size_t i, std::size_t c) const;
  [[nodiscard]] double natural(double t, std::size_t i, std::size_t c) const;

  SplineKind kind_;
  int dimension_;
  std::vector<Entry> entries_;
  std::vector<SplineValue> second_derivatives_;  // of the natural spline, at every entry
};

}  // namespace durer::functions
