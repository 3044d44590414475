// Working-space pixels → the numbers that stand in a file (shading §1.5, §1.7).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "image/dither.h"
#include "image/image.h"

namespace durer::image {

/// Rows of unsigned codes, channels interleaved: (grey or r g b) then alpha.
struct Codes {
  int channels = 0;
  int sample_bits = 8;  // 8 or 16: the width of a sample in the file
  std::vector<std::uint16_t> values;
};

/// How many bits carry information, and how wide a sample is. Codes are widened by replication.
struct Depth {
  int bits = 8;
  int sample_bits = 8;
};

/// The depth for a format with 8-bit and 16-bit samples: 5…8 bits go into 8, 9…16 into 16.
[[nodiscard]] Depth depth_for(int bits);

class CodeTable;

/// Codes of a picture, row by row from the top if they are dithered: errors of rounding are handed
/// down. Else in any order, and to several threads.
class Coder {
 public:
  /// As to_codes(); `image` must stay.
  Coder(const Image& image, const Encoding& encoding, Depth depth, bool alpha);
  ~Coder();

  [[nodiscard]] int channels() const { return colours_ + (alpha_ ? 1 : 0); }
  [[nodiscard]] int sample_bits() const { return depth_.sample_bits; }
  /// The codes of row `y`, of width times channels numbers.
  void row(int y, std::span<std::uint16_t> out);
  /// The same as they stand in a file, the high byte of a code first.
  void row_bytes(int y, std::span<unsigned char> out);

 private:
  template <typename Put>
  void each_code(int y, Put put);

  const Image* image_;
  Encoding encoding_;
  Depth depth_;
  bool alpha_;
  int colours_;
  Ditherer dither_;
  std::unique_ptr<const CodeTable> table_;  // if it is worth it
};

/// Encodes by `encoding` (code = floor(clamp(E(c), 0, 1)·M + ½)); `alpha` asks for the channel and
/// for colours divided by it, with the brightness rule of shading §1.7. NaN becomes 0.
[[nodiscard]] Codes to_codes(const Image& image, const Encoding& encoding, Depth depth, bool alpha);

/// Linear light for EXR and HDR, premultiplied, same channel order.
struct Samples {
  int channels = 0;
  std::vector<float> values;
};
[[nodiscard]] Samples to_linear(const Image& image, const Encoding& encoding, bool greyscale,
                                bool alpha);

/// The curve that codes of an integer format are stored in.
[[nodiscard]] GammaCurve stored_curve(const Encoding& encoding);

/// Working-space number → stored number E(c), before rounding.
[[nodiscard]] float stored(const Encoding& encoding, float working);

/// The reverse.
[[nodiscard]] float working(const Encoding& encoding, float stored);

}  // namespace durer::image
