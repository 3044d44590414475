// Truevision Targa, 8 bits; compression 1 (`+FC`) packs runs.
#include "image/oiio_file.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  Attributes attributes = curve_attributes(stored_curve(encoding));
  attributes.emplace_back("compression", encoding.compression > 0 ? "rle" : "none");
  return file_of_codes("targa", image, to_codes(image, encoding, {}, encoding.alpha),
                       std::move(attributes));
}

}  // namespace

extern constinit const Format tga_format = {
    .name = "tga",
    .extension = ".tga",
    .spellings = "",
    .letter = 'T',
    .doc = "Truevision Targa, 8 bits",
    .linear = false,
    .has_alpha = true,
    .max_bits = 8,
    .encode = encode,
};

}  // namespace durer::image
