// The cells of `crackle` and `facets`: every unit cube holds one random point (textures §5.1).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "functions/noise.h"

namespace durer::tracer::patterns {

/// One of the 81 cubes around a point's own that may hold one of the points nearest to it.
struct CrackleCube {
  int x, y, z;
};

/// Nearest cubes first.
inline constexpr std::array<CrackleCube, 81> crackle_cubes = [] {
  std::array<CrackleCube, 81> cubes{};
  std::size_t n = 0;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const int far = (x * x == 4) + (y * y == 4) + (z * z == 4);
        if (far <= 1) {
          cubes[n++] = {x, y, z};
        }
      }
    }
  }
  const auto size = [](const CrackleCube& c) { return c.x * c.x + c.y * c.y + c.z * c.z; };
  for (std::size_t i = 1; i < cubes.size(); ++i) {  // insertion sort: stable, and constexpr
    for (std::size_t k = i; k > 0 && size(cubes[k]) < size(cubes[k - 1]); --k) {
      const CrackleCube swapped = cubes[k];
      cubes[k] = cubes[k - 1];
      cubes[k - 1] = swapped;
    }
  }
  return cubes;
}();

/// The cube that crackle finds a coordinate in: one lower exactly at whole numbers.
[[nodiscard]] inline std::int64_t crackle_cell(double x) {
  return static_cast<std::int64_t>(std::floor(x - epsilon));
}

/// The random point of a cube.
[[nodiscard]] inline dvec3 crackle_point(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto s = static_cast<unsigned>(
      functions::hash3(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)));
  return {static_cast<double>(x) + functions::uniform_table(s),
          static_cast<double>(y) + functions::uniform_table(s + 1),
          static_cast<double>(z) + functions::uniform_table(s + 2)};
}

}  // namespace durer::tracer::patterns
