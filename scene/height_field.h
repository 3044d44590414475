#pragma once

#include <cstdint>
#include <vector>

namespace durer::scene {

/// Heights over a grid, as a picture gives them (objects §10.11): row by row, the first row at the
/// far side (z = 1), 0 to 65535.
struct HeightField {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint16_t> heights;
};

}  // namespace durer::scene
