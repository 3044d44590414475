#pragma once

#include <array>
#include <cstddef>

namespace durer {

/// Up to N real numbers, ascending.
template <std::size_t N>
struct Roots {
  std::array<double, N> values{};
  std::size_t count = 0;

  void add(double x) { values[count++] = x; }
  [[nodiscard]] const double* begin() const { return values.data(); }
  [[nodiscard]] const double* end() const { return values.data() + count; }
};

}  // namespace durer
