// TIFF, 8 or 16 bits, lossless; alpha is marked as not premultiplied. The curve is not told:
// readers take integer TIFF for sRGB, and OpenImageIO before 2.5.12 spoils files in memory that
// have EXIF data, where it would stand (OpenImageIO pull request 4300).
#include "image/oiio_file.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  return file_of_codes("tiff", image,
                       to_codes(image, encoding, depth_for(encoding.bits), encoding.alpha),
                       {{"compression", "zip"}});
}

}  // namespace

extern constinit const Format tiff_format = {
    .name = "tiff",
    .extension = ".tif",
    .spellings = ".tiff",
    .letter = 0,
    .doc = "TIFF, 8 or 16 bits",
    .linear = false,
    .has_alpha = true,
    .max_bits = 16,
    .encode = encode,
};

}  // namespace durer::image
