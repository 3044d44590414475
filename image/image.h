// A finished picture in memory, and the one way out to a file.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/gamma.h"
#include "base/large_array.h"

namespace durer::image {

/// Row-major pixels, top row first, four floats each: red, green, blue in the scene's working
/// space, premultiplied, then alpha = 1 - transmittance.
struct Image {
  int width = 0;
  int height = 0;
  LargeArray<float> pixels;

  Image() = default;
  Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * h * 4) {}
  [[nodiscard]] std::span<float, 4> at(int x, int y) {
    return std::span<float, 4>(&pixels[(static_cast<std::size_t>(y) * width + x) * 4], 4);
  }
  [[nodiscard]] std::span<const float, 4> at(int x, int y) const {
    return std::span<const float, 4>(&pixels[(static_cast<std::size_t>(y) * width + x) * 4], 4);
  }
};

/// How rounding to codes is hidden: Bayer's patterns, or errors handed on to one, three or four
/// neighbours (shading §1.6).
enum class Dither : std::uint8_t { none, b2, b3, b4, d1, d2, fs };

/// How the picture becomes numbers in a file (shading §1.5).
struct Encoding {
  /// Working space of the picture; ignored when `encode` is off.
  GammaCurve working;
  /// Off in gamma mode OFF: integer formats get the numbers as they are, and the linear formats
  /// (EXR, HDR) take them for sRGB-encoded.
  bool encode = true;
  GammaCurve file = GammaCurve::srgb();  // integer formats only
  int bits = 8;                          // per channel, 5…16, where the format has a choice
  bool greyscale = false;
  bool alpha = false;
  Dither dither = Dither::none;          // PNG, TGA, BMP and PPM
  int compression = -1;  // JPEG quality 0…100, PNG 0…9, TGA 0 or 1; -1: default
  int threads = 1;       // that work on it, where a format has use for several; 0: one per processor
};

/// The bytes of a whole file, or what stands in the way.
struct Encoded {
  std::vector<unsigned char> bytes;
  std::optional<std::string> error;
};

/// One output format; see formats.def for the list.
struct Format {
  std::string_view name;       // "png"
  std::string_view extension;  // ".png"
  std::string_view spellings;  // other extensions of it: ".jpeg .jpe"
  char letter;                 // in `+FN`, `Output_File_Type=N`; 0: none
  std::string_view doc;
  bool linear;  // holds linear light, no file gamma
  bool has_alpha;
  int max_bits;  // 8, 16 or 32
  Encoded (*encode)(const Image& image, const Encoding& encoding);
};

[[nodiscard]] std::span<const Format* const> formats();
/// By file extension ("a.PNG"), case-insensitive, with the usual second spellings (.jpeg, .tif);
/// null if unknown.
[[nodiscard]] const Format* format_of(std::string_view path);
/// By name ("png", "jpg" too) or by letter ("N"), case-insensitive; null if unknown.
[[nodiscard]] const Format* format_named(std::string_view name);

/// Writes `image` to `path` ("-": standard output) so that the file is either complete or
/// untouched: a temporary file beside it, renamed when whole. Returns what went wrong, or nothing.
[[nodiscard]] std::optional<std::string> write(const Image& image, const std::string& path,
                                               const Format& format, const Encoding& encoding);

/// The same for bytes of any kind; `path` is a file.
[[nodiscard]] std::optional<std::string> write_file(const std::string& path,
                                                    std::span<const unsigned char> bytes);

/// Tells, before a long render, why a file could not be written to `path` ("-" and an empty path
/// always can). Leaves nothing behind.
[[nodiscard]] std::optional<std::string> probe(const std::string& path);

/// One pixel as display-ready 8-bit sRGB, for previews in a terminal.
[[nodiscard]] std::uint32_t display_rgb(const Image& image, int x, int y, const Encoding& encoding);

}  // namespace durer::image
