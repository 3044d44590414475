// Portable Network Graphics, 8 or 16 bits. Greyscale is always 16 bits, as in the oracle.
// The curve goes into an sRGB or a gAMA chunk. Written by libpng itself, not through OpenImageIO:
// nearly every picture is a PNG, and loading OpenImageIO takes longer than rendering many a scene.
#include <png.h>

#include <csetjmp>

#include "image/codes.h"

namespace durer::image {
namespace {

void append(png_structp png, png_bytep data, std::size_t size) {
  auto& out = *static_cast<std::vector<unsigned char>*>(png_get_io_ptr(png));
  out.insert(out.end(), data, data + size);
}

void keep_message(png_structp png, const char* message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

void write_header(png_structp png, png_infop info, const Image& image, const Codes& codes,
                  const Encoding& encoding) {
  static constexpr int colour_types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                         PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), codes.sample_bits,
               colour_types[codes.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const GammaCurve curve = stored_curve(encoding);
  if (curve.kind == GammaCurve::Kind::srgb) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  } else {
    png_set_gAMA(png, info, curve.kind == GammaCurve::Kind::power ? 1.0 / curve.gamma : 1.0);
  }
  if (encoding.compression >= 0) png_set_compression_level(png, encoding.compression);
  png_write_info(png, info);
}

/// Samples as PNG stores them: 16-bit ones with the high byte first.
std::vector<unsigned char> to_bytes(const Codes& codes) {
  std::vector<unsigned char> bytes;
  bytes.reserve(codes.values.size() * (codes.sample_bits == 16 ? 2 : 1));
  for (const std::uint16_t v : codes.values) {
    if (codes.sample_bits == 16) bytes.push_back(static_cast<unsigned char>(v >> 8));
    bytes.push_back(static_cast<unsigned char>(v & 0xFF));
  }
  return bytes;
}

/// False if libpng stopped with an error: it jumps back to here, so nothing in this function may
/// have a destructor, and it must not become part of one that has.
[[gnu::noinline]] bool run(png_structp png, png_infop info, const Image& image, const Codes& codes,
                           const Encoding& encoding, const unsigned char* rows,
                           std::size_t stride) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  write_header(png, info, image, codes, encoding);
  for (int y = 0; y < image.height; ++y)
    png_write_row(png, rows + static_cast<std::size_t>(y) * stride);
  png_write_end(png, nullptr);
  return true;
}

Encoded encode(const Image& image, const Encoding& encoding) {
  if (image.width <= 0 || image.height <= 0) return {.bytes = {}, .error = "it has no pixels"};
  const Depth depth = depth_for(encoding.greyscale ? 16 : encoding.bits);
  const Codes codes = to_codes(image, encoding, depth, encoding.alpha);
  const std::vector<unsigned char> rows = to_bytes(codes);
  Encoded file;
  std::string message = "out of memory";
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info != nullptr) png_set_write_fn(png, &file.bytes, append, nullptr);
  const bool whole = info != nullptr && run(png, info, image, codes, encoding, rows.data(),
                                            rows.size() / static_cast<std::size_t>(image.height));
  png_destroy_write_struct(&png, &info);
  if (!whole) return {.bytes = {}, .error = std::move(message)};
  return file;
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
