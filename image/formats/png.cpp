// Portable Network Graphics, 8 or 16 bits. Greyscale is always 16 bits, as in the oracle.
// The curve goes into an sRGB or a gAMA chunk.
#include "image/oiio_file.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  const Depth depth = depth_for(encoding.greyscale ? 16 : encoding.bits);
  Attributes attributes = curve_attributes(stored_curve(encoding));
  if (encoding.compression >= 0)
    attributes.emplace_back("png:compressionLevel", encoding.compression);
  return file_of_codes("png", image, to_codes(image, encoding, depth, encoding.alpha),
                       std::move(attributes));
}

}  // namespace

extern constinit const Format png_format = {
    .name = "png",
    .extension = ".png",
    .spellings = "",
    .letter = 'N',
    .doc = "Portable Network Graphics, 8 or 16 bits",
    .linear = false,
    .has_alpha = true,
    .max_bits = 16,
    .encode = encode,
};

}  // namespace durer::image
