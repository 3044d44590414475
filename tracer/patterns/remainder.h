// std::fmod without its loops, for the quotients that textures have. Exact, as fmod is.
#pragma once

#include <cmath>
#include <cstdint>

namespace durer::tracer {

/// fmod(x, m) where m > 0 is a number of single precision.
[[nodiscard]] inline double remainder_of_single(double x, double m) {
  if (std::abs(x) < m) return x;
  const double quotient = x / m;
  if (!(std::abs(quotient) < 0x1p28)) return std::fmod(x, m);
  // 28 bits times 24 bits are exact, and so is the difference: it is no longer than x is. Division
  // may have rounded up to the next whole number.
  const double r = x - static_cast<double>(static_cast<std::int64_t>(quotient)) * m;
  if (x >= 0) return r < 0 ? r + m : r;
  return r > 0 ? r - m : r == 0 ? -0.0 : r;
}

/// fmod(x, m) where m > 0.
[[nodiscard]] inline double remainder(double x, double m) {
  const double size = std::abs(x);
  if (size < m) return x;
  const double quotient = size / m;
  if (!(quotient < 0x1p23)) return std::fmod(x, m);
  // 24 bits times the upper 24 or the lower 29 of m are exact, and so are the differences: the first
  // is about as long as x, the second is the result.
  const double upper = static_cast<float>(m);
  const auto whole = static_cast<double>(static_cast<std::int32_t>(quotient));
  double r = size - whole * upper - whole * (m - upper);
  if (r < 0) r += m;  // division had rounded up
  if (r >= m) r -= m;
  return x < 0 ? -r : r;
}

}  // namespace durer::tracer
