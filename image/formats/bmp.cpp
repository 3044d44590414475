// Windows bitmap, 8 bits.
#include "image/oiio_file.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  return file_of_codes("bmp", image, to_codes(image, encoding, {}, encoding.alpha),
                       curve_attributes(stored_curve(encoding)));
}

}  // namespace

extern constinit const Format bmp_format = {
    .name = "bmp",
    .extension = ".bmp",
    .spellings = "",
    .letter = 'B',
    .doc = "Windows bitmap, 8 bits",
    .linear = false,
    .has_alpha = true,
    .max_bits = 8,
    .encode = encode,
};

}  // namespace durer::image
