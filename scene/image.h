// Pictures as textures look them up, and density files, as plain data (textures §8.6, §12).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/gamma.h"
#include "base/picture.h"
#include "base/vec.h"

namespace durer::scene {

/// `filter 3, 0.5`: what one colour of a palette gets.
struct PaletteChange {
  std::uint32_t index = 0;
  float value = 0;
};

/// A picture and how points find their pixels in it. The picture itself is shared by all that show
/// the same file.
struct Image {
  enum class Projection : std::uint8_t { planar, spherical, cylindrical, toroidal };
  enum class Interpolation : std::uint8_t { nearest, bilinear, bicubic, distance };

  std::shared_ptr<const Picture> picture;
  GammaCurve stored;   // from the numbers of the file to light …
  GammaCurve working;  // … and from there to the numbers of the scene
  Projection projection = Projection::planar;
  Interpolation interpolation = Interpolation::nearest;
  bool once = false;           // nothing beyond one copy
  bool use_index = false;      // bump_map: heights are numbers of the palette
  bool use_alpha = false;      // image_pattern: how transparent it is
  bool premultiplied = false;  // colours are stored multiplied by alpha
  dvec2 repeat{1.0};
  dvec2 offset{0.0};  // in whole pictures
  /// What all colours get; palettes get it instead of what they have, others add it.
  std::optional<float> filter_all;
  std::optional<float> transmit_all;
  std::vector<PaletteChange> filter;
  std::vector<PaletteChange> transmit;
};

/// Samples in a box, x fastest, z slowest, as a density file holds them.
struct Voxels {
  std::array<std::uint32_t, 3> size{};
  std::uint32_t width = 1;           // bytes of a sample: 1, 2 or 4
  std::vector<std::uint8_t> bytes;   // big-endian

  /// The sample at a place inside, 0 to 1.
  [[nodiscard]] double at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    const std::size_t i = (std::size_t{z} * size[1] + y) * size[0] + x;
    const std::uint8_t* b = &bytes[i * width];
    if (width == 1) return b[0] / 255.0;
    if (width == 2) return (b[0] << 8 | b[1]) / 65535.0;
    const std::uint32_t v = std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 |
                            std::uint32_t{b[2]} << 8 | b[3];
    return v / 4294967295.0;
  }
};

}  // namespace durer::scene
