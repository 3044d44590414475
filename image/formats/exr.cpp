// OpenEXR with half floats: linear light, premultiplied alpha.
#include "image/oiio_file.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  return file_of_samples("openexr", image,
                         to_linear(image, encoding, encoding.greyscale, encoding.alpha), true,
                         {{"compression", "zip"}});
}

}  // namespace

extern constinit const Format exr_format = {
    .name = "exr",
    .extension = ".exr",
    .spellings = "",
    .letter = 'E',
    .doc = "OpenEXR, half floats, linear light",
    .linear = true,
    .has_alpha = true,
    .max_bits = 16,
    .encode = encode,
};

}  // namespace durer::image
