// Portable pixmap (P6), greyscale as graymap (P5); any maximum of 5…16 bits stands in the header,
// so codes are not widened. Written by hand: header and big-endian samples are all there is.
#include <fmt/format.h>

#include "image/codes.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  Encoding stored_as = encoding;
  if (encoding.greyscale) stored_as.file = stored_as.working;  // graymaps carry no gamma (§1.5)
  const int bits = encoding.bits;
  const Codes codes = to_codes(image, stored_as, {bits, bits}, false);
  const std::string header = fmt::format("P{}\n{} {}\n{}\n", encoding.greyscale ? 5 : 6,
                                         image.width, image.height, (1 << bits) - 1);
  Encoded file;
  file.bytes.assign(header.begin(), header.end());
  for (const std::uint16_t code : codes.values) {
    if (bits > 8) file.bytes.push_back(static_cast<unsigned char>(code >> 8));
    file.bytes.push_back(static_cast<unsigned char>(code & 0xFF));
  }
  return file;
}

}  // namespace

extern constinit const Format ppm_format = {
    .name = "ppm",
    .extension = ".ppm",
    .spellings = ".pgm .pnm",
    .letter = 'P',
    .doc = "Portable pixmap, up to 16 bits",
    .linear = false,
    .has_alpha = false,
    .max_bits = 16,
    .encode = encode,
};

}  // namespace durer::image
