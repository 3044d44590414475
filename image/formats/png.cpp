// Portable Network Graphics, 8 or 16 bits. Greyscale is always 16 bits, as in the oracle.
// The curve goes into an sRGB or a gAMA chunk. Written by libpng itself, not through OpenImageIO:
// nearly every picture is a PNG, and loading OpenImageIO takes longer than rendering many a scene.
// libpng makes the chunks around the pixels; these are compressed by png_rows.h.
#include <png.h>

#include <algorithm>
#include <csetjmp>

#include "image/codes.h"
#include "image/png_rows.h"

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

void write_header(png_structp png, png_infop info, const Image& image, const Coder& coder,
                  const Encoding& encoding) {
  static constexpr int colour_types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                         PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), coder.sample_bits(),
               colour_types[coder.channels() - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const GammaCurve curve = stored_curve(encoding);
  if (curve.kind == GammaCurve::Kind::srgb) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  } else {
    png_set_gAMA(png, info, curve.kind == GammaCurve::Kind::power ? 1.0 / curve.gamma : 1.0);
  }
  png_write_info(png, info);
}

/// The compressed rows; empty if memory ran out.
std::vector<unsigned char> compressed(const Image& image, const Encoding& encoding, Coder& coder) {
  const std::size_t samples = static_cast<std::size_t>(image.width) * coder.channels();
  const std::size_t width = coder.sample_bits() / 8U;
  const std::size_t size = samples * width;
  PngRows rows(size, coder.channels() * width, image.height, encoding.compression);
  const auto code = [&coder](std::size_t y, std::span<unsigned char> row) {
    coder.row_bytes(static_cast<int>(y), row);
  };
  if (encoding.dither == Dither::none) return rows.stream(code, encoding.threads);
  LargeArray<unsigned char> all(size * image.height);
  const auto row_of_all = [&](std::size_t y) { return std::span(&all[size * y], size); };
  for (int y = 0; y < image.height; ++y) code(y, row_of_all(y));
  const auto copy = [&](std::size_t y, std::span<unsigned char> row) {
    std::copy_n(row_of_all(y).begin(), size, row.begin());
  };
  return rows.stream(copy, encoding.threads);
}

/// False if libpng stopped with an error: it jumps back to here, so nothing in this function may
/// have a destructor, and it must not become part of one that has.
[[gnu::noinline]] bool run(png_structp png, png_infop info, const Image& image, const Coder& coder,
                           const Encoding& encoding, const std::vector<unsigned char>& stream) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  write_header(png, info, image, coder, encoding);
  constexpr std::size_t most = 1 << 20;  // of a chunk
  for (std::size_t at = 0; at < stream.size(); at += most) {
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), stream.data() + at,
                    std::min(most, stream.size() - at));
  }
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
  return true;
}

Encoded encode(const Image& image, const Encoding& encoding) {
  if (image.width <= 0 || image.height <= 0) return {.bytes = {}, .error = "it has no pixels"};
  const Depth depth = depth_for(encoding.greyscale ? 16 : encoding.bits);
  Coder coder(image, encoding, depth, encoding.alpha);
  const std::vector<unsigned char> stream = compressed(image, encoding, coder);
  Encoded file;
  std::string message = "out of memory";
  if (stream.empty()) return {.bytes = {}, .error = std::move(message)};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  constexpr std::size_t around = 1 << 12;  // bytes of chunks, about
  file.bytes.reserve(stream.size() + around);
  if (info != nullptr) png_set_write_fn(png, &file.bytes, append, nullptr);
  const bool whole = info != nullptr && run(png, info, image, coder, encoding, stream);
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
