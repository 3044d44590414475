// Dithering: rounding errors as a pattern, or handed on to the neighbours (shading §1.6).
#pragma once

#include <array>
#include <vector>

#include "image/image.h"

namespace durer::image {

/// The state of one picture's dithering; pixels are asked for row by row, from the left.
class Ditherer {
 public:
  Ditherer(Dither method, int width);

  [[nodiscard]] bool idle() const { return method_ == Dither::none; }
  /// Goes to a pixel.
  void enter(int x, int y);
  /// What errors of other pixels add to `channel` here, in working space.
  [[nodiscard]] float offset(int channel) const { return offsets_[static_cast<std::size_t>(channel)]; }
  /// What is added to a code before it is rounded, in codes: -0.5 to 0.5.
  [[nodiscard]] float threshold() const { return threshold_; }
  /// Hands on what rounding has done to `channel` of this pixel, in working space.
  void spread(int channel, float error);

 private:
  using Errors = std::array<float, 4>;  // by channel

  [[nodiscard]] bool two_rows() const { return method_ == Dither::d2 || method_ == Dither::fs; }
  void add(std::vector<Errors>& row, int x, int channel, float error);

  Dither method_;
  int width_;
  int x_ = 0;
  float threshold_ = 0;
  Errors offsets_{};
  Errors last_{};  // of the pixel before, in scan order
  std::vector<Errors> here_, below_;
};

}  // namespace durer::image
