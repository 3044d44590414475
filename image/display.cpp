#include <algorithm>
#include <cmath>

#include "image/codes.h"

namespace durer::image {

std::uint32_t display_rgb(const Image& image, int x, int y, const Encoding& encoding) {
  Encoding display = encoding;
  display.file = GammaCurve::srgb();
  const auto pixel = image.at(x, y);
  std::uint32_t rgb = 0;
  for (int i = 0; i < 3; ++i) {
    const float v = stored(display, pixel[i]);
    const float clamped = v > 0 ? std::min(v, 1.0F) : 0.0F;  // NaN → 0
    rgb = rgb << 8 | static_cast<std::uint32_t>(std::lround(clamped * 255.0F));
  }
  return rgb;
}

}  // namespace durer::image
