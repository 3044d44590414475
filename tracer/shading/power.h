// Powers as finishes have them: mostly of whole exponents.
#pragma once

#include <cmath>

namespace durer::tracer {

/// The exponent of a highlight or of `brilliance`.
class Exponent {
 public:
  Exponent() = default;
  Exponent(float value) : value_(value), whole_(0) {  // NOLINT: meant to convert
    constexpr float most = 256;
    if (value >= 1 && value <= most && value == std::floor(value)) {
      whole_ = static_cast<unsigned>(value);
    }
  }

  [[nodiscard]] bool is_one() const { return whole_ == 1; }
  /// The exponent, if powers are multiplied out; else 0.
  [[nodiscard]] unsigned whole() const { return whole_; }
  operator float() const { return value_; }  // NOLINT: meant to convert

  /// x to this power, x >= 0. Whole exponents n are multiplied out, in a third of the time; the
  /// relative error stays below n · 1.2e-16, which the single precision that follows does not show.
  [[nodiscard]] double of(double x) const {
    if (whole_ == 0) return std::pow(x, static_cast<double>(value_));
    double y = 1;
    for (unsigned n = whole_;; x *= x) {
      if ((n & 1U) != 0) y *= x;
      if ((n >>= 1U) == 0) return y;
    }
  }

 private:
  float value_ = 1;
  unsigned whole_ = 1;  // 0: not a whole number, or a large one
};

}  // namespace durer::tracer
