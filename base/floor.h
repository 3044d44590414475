// Rounding down without a call: what every x86-64 processor has is no instruction for it.
#pragma once

#include <cmath>
#include <cstdint>

namespace durer {

/// std::floor(x), but +0 for -0.
[[nodiscard]] inline double floored(double x) {
  if (!(std::abs(x) < 0x1p52)) return x;  // whole already, or not a number
  const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
  return whole > x ? whole - 1 : whole;
}

}  // namespace durer
