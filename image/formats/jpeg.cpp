// JPEG, 8 bits. Colour is not subsampled: rendered edges suffer visibly from it.
#include "image/oiio_file.h"

namespace durer::image {
namespace {

Encoded encode(const Image& image, const Encoding& encoding) {
  const int quality = encoding.compression >= 0 ? encoding.compression : 95;
  Encoding plain = encoding;
  plain.dither = Dither::none;  // its own artefacts would undo it
  Attributes attributes = curve_attributes(stored_curve(encoding));
  attributes.emplace_back("Compression", "jpeg:" + std::to_string(quality));
  attributes.emplace_back("jpeg:subsampling", "4:4:4");
  return file_of_codes("jpeg", image, to_codes(image, plain, {}, false), std::move(attributes));
}

}  // namespace

extern constinit const Format jpeg_format = {
    .name = "jpeg",
    .extension = ".jpg",
    .spellings = ".jpeg .jpe",
    .letter = 'J',
    .doc = "JPEG, 8 bits",
    .linear = false,
    .has_alpha = false,
    .max_bits = 8,
    .encode = encode,
};

}  // namespace durer::image
