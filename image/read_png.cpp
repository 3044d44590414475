#include "image/read_png.h"

#include <png.h>

#include <csetjmp>
#include <string>

namespace durer::image {
namespace {

void keep_message(png_structp png, const char* message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}
void no_warning(png_structp /*png*/, const char* /*message*/) {}

/// What the header tells; the rows are prepared to be read in whole bytes.
struct Header {
  png_uint_32 width;
  png_uint_32 height;
  int bits;
  int colour_type;
  png_size_t stride;
};

/// False if libpng stopped with an error: it jumps back to here, so nothing in this function may
/// have a destructor, and it must not become part of one that has.
[[gnu::noinline]] bool read_header(png_structp png, png_infop info, std::FILE* file, Header& h) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_init_io(png, file);
  png_read_info(png, info);
  h.colour_type = png_get_color_type(png, info);
  h.bits = png_get_bit_depth(png, info);
  h.width = png_get_image_width(png, info);
  h.height = png_get_image_height(png, info);
  if (h.bits < 8) {
    if (h.colour_type == PNG_COLOR_TYPE_PALETTE) {
      png_set_packing(png);
    } else {
      png_set_expand_gray_1_2_4_to_8(png);
    }
    h.bits = 8;
  }
  // A transparent colour that is no grey is passed over, as the oracle does.
  if (h.colour_type == PNG_COLOR_TYPE_GRAY) png_set_tRNS_to_alpha(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  h.stride = png_get_rowbytes(png, info);
  return true;
}

[[gnu::noinline]] bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  return true;
}

void copy_palette(png_structp png, png_infop info, Picture& out) {
  png_colorp colours = nullptr;
  int count = 0;
  png_get_PLTE(png, info, &colours, &count);
  png_bytep alphas = nullptr;
  int alpha_count = 0;
  png_get_tRNS(png, info, &alphas, &alpha_count, nullptr);
  for (int i = 0; i < count; ++i) {
    const std::uint8_t alpha = i < alpha_count ? alphas[i] : std::uint8_t{255};
    out.palette.push_back({colours[i].red, colours[i].green, colours[i].blue, alpha});
  }
}

PictureRead read_with(png_structp png, png_infop info, std::FILE* file,
                      const std::string& message) {
  Header h{};
  if (!read_header(png, info, file, h)) return {nullptr, message};
  auto picture = std::make_shared<Picture>();
  picture->width = h.width;
  picture->height = h.height;
  picture->bits = static_cast<std::uint32_t>(h.bits);
  picture->channels = png_get_channels(png, info);
  std::vector<unsigned char> bytes(h.stride * h.height);
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < h.height; ++y) rows.push_back(bytes.data() + y * h.stride);
  if (!read_rows(png, rows.data())) return {nullptr, message};
  picture->codes.reserve(std::size_t{h.width} * h.height * picture->channels);
  for (const png_bytep row : rows) {
    for (std::size_t i = 0; i < h.stride; i += picture->bits / 8) {
      picture->codes.push_back(
          picture->bits == 16 ? static_cast<std::uint16_t>(row[i] << 8 | row[i + 1]) : row[i]);
    }
  }
  if (h.colour_type == PNG_COLOR_TYPE_PALETTE) copy_palette(png, info, *picture);
  picture->weighed_grey = picture->bits == 8 && picture->channels == 1 && picture->palette.empty();
  int intent = 0;
  picture->file_srgb = png_get_sRGB(png, info, &intent) != 0;
  double gamma = 0;
  if (png_get_gAMA(png, info, &gamma) != 0 && gamma > 0) picture->file_gamma = 1 / gamma;
  return {std::move(picture), {}};
}

}  // namespace

PictureRead read_png(std::FILE* file) {
  std::string message = "out of memory";
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, no_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  PictureRead read{nullptr, message};
  if (info != nullptr) read = read_with(png, info, file, message);
  png_destroy_read_struct(&png, &info, nullptr);
  return read;
}

}  // namespace durer::image
