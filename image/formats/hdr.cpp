// Radiance RGBE: linear light, one exponent for three 8-bit mantissas.
#include "image/oiio_file.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  return file_of_samples("hdr", image, to_linear(image, encoding, false, false), false, {});
}

}  // namespace

extern constinit const Format hdr_format = {
    .name = "hdr",
    .extension = ".hdr",
    .spellings = ".rgbe .pic",
    .letter = 'H',
    .doc = "Radiance RGBE, linear light",
    .linear = true,
    .has_alpha = false,
    .max_bits = 8,
    .encode = encode,
};

}  // namespace durer::image
