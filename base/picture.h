// A picture as a file holds it: no curve undone, no palette looked up, no alpha multiplied.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace durer {

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 1;  // 1 grey, 2 grey and alpha, 3 red green blue, 4 and alpha
  std::uint32_t bits = 8;      // 8 or 16: `codes`; 32: `samples`
  /// Rows from the top, channels of a pixel side by side.
  std::vector<std::uint16_t> codes;
  std::vector<float> samples;
  /// Red, green, blue, alpha; not empty: codes are indices into it, one channel of 8 bits.
  std::vector<std::array<std::uint8_t, 4>> palette;
  /// Decoding exponent that the file names, such as 2.2.
  std::optional<double> file_gamma;
  bool file_srgb = false;      // the file says that its curve is that of sRGB
  bool premultiplied = false;  // colours are stored multiplied by alpha
  /// Grey bytes of a PNG file, which the oracle keeps as bytes of a weighted sum.
  bool weighed_grey = false;

  [[nodiscard]] bool is_real() const { return bits == 32; }
  [[nodiscard]] std::size_t index(std::uint32_t x, std::uint32_t y,
                                  std::uint32_t channel = 0) const {
    return (static_cast<std::size_t>(y) * width + x) * channels + channel;
  }
};

/// A picture, or why there is none.
struct PictureRead {
  std::shared_ptr<const Picture> picture;
  std::string error;
};

/// Reads a file; `kind` is the word of the language for its format ("png", "tga"), or empty: then
/// the file's name tells.
using PictureReader = std::function<PictureRead(const std::string& path, const std::string& kind)>;

}  // namespace durer
