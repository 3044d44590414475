#include "image/read_palette.h"

#include <cstddef>
#include <vector>

namespace durer::image {
namespace {

/// Reads whole numbers, least byte first; once the file has ended, everything is 0 and `ok` false.
class Bytes {
 public:
  explicit Bytes(std::FILE* file) : file_(file) {}

  bool ok = true;

  std::uint32_t number(int bytes) {
    std::uint32_t n = 0;
    for (int i = 0; i < bytes; ++i) n |= static_cast<std::uint32_t>(byte()) << (8 * i);
    return n;
  }
  std::uint8_t byte() {
    const int c = std::fgetc(file_);
    if (c == EOF) ok = false;
    return c == EOF ? std::uint8_t{0} : static_cast<std::uint8_t>(c);
  }
  void seek(std::uint32_t offset) { ok = std::fseek(file_, offset, SEEK_SET) == 0 && ok; }
  void skip(std::uint32_t count) { ok = std::fseek(file_, count, SEEK_CUR) == 0 && ok; }

 private:
  std::FILE* file_;
};

/// Larger pictures with a palette are a mistake, or malice.
constexpr std::uint32_t most_pixels_a_side = 32768;

bool is_size(std::uint32_t width, std::uint32_t height) {
  return width > 0 && height > 0 && width <= most_pixels_a_side && height <= most_pixels_a_side;
}

Picture empty_picture(std::uint32_t width, std::uint32_t height) {
  Picture p;
  p.width = width;
  p.height = height;
  return p;
}

std::optional<Picture> checked(Picture p, bool ok) {
  for (const std::uint16_t code : p.codes) ok = ok && code < p.palette.size();
  if (!ok) return std::nullopt;
  return p;
}

}  // namespace

std::optional<Picture> read_bmp_palette(std::FILE* file) {
  Bytes in(file);
  if (in.number(2) != 0x4D42) return std::nullopt;  // "BM"
  in.skip(8);
  const std::uint32_t pixels_at = in.number(4);
  const std::uint32_t header = in.number(4);
  const std::uint32_t width = in.number(4);
  const auto rows = static_cast<std::int32_t>(in.number(4));  // negative: from the top
  in.skip(2);
  const std::uint32_t bits = in.number(2);
  const std::uint32_t packing = in.number(4);
  in.skip(12);
  std::uint32_t colours = in.number(4);
  const bool from_top = rows < 0;
  const std::uint32_t height =
      from_top ? 0U - static_cast<std::uint32_t>(rows) : static_cast<std::uint32_t>(rows);
  if (!in.ok || header < 40 || packing != 0 || (bits != 1 && bits != 4 && bits != 8) ||
      !is_size(width, height)) {
    return std::nullopt;
  }
  if (colours == 0 || colours > 256) colours = 1U << bits;
  Picture p = empty_picture(width, height);
  in.seek(14 + header);
  for (std::uint32_t i = 0; i < colours; ++i) {
    const std::uint32_t bgr = in.number(4);
    p.palette.push_back({static_cast<std::uint8_t>(bgr >> 16U),
                         static_cast<std::uint8_t>(bgr >> 8U), static_cast<std::uint8_t>(bgr),
                         255});
  }
  p.codes.resize(std::size_t{width} * height);
  in.seek(pixels_at);
  for (std::uint32_t row = 0; row < height && in.ok; ++row) {
    const std::uint32_t y = from_top ? row : height - 1 - row;
    const std::uint32_t stride = (width * bits + 31) / 32 * 4;
    std::uint32_t packed = 0;
    for (std::uint32_t x = 0, taken = 0; taken < stride; ++taken) {
      packed = in.byte();
      for (std::uint32_t shift = 8; shift > 0 && x < width; ++x) {
        shift -= bits;
        p.codes[p.index(x, y)] = static_cast<std::uint16_t>((packed >> shift) & ((1U << bits) - 1));
      }
    }
  }
  return checked(std::move(p), in.ok);
}

std::optional<Picture> read_tga_palette(std::FILE* file) {
  Bytes in(file);
  const std::uint32_t name_length = in.byte();
  const std::uint32_t has_palette = in.byte();
  const std::uint32_t type = in.byte();  // 1: bytes, 9: runs of bytes
  const std::uint32_t first = in.number(2);
  const std::uint32_t colours = in.number(2);
  const std::uint32_t colour_bits = in.byte();
  in.skip(4);
  const std::uint32_t width = in.number(2);
  const std::uint32_t height = in.number(2);
  const std::uint32_t bits = in.byte();
  const std::uint32_t flags = in.byte();
  if (!in.ok || has_palette != 1 || (type != 1 && type != 9) || bits != 8 ||
      (colour_bits != 24 && colour_bits != 32) || first + colours > 256 ||
      !is_size(width, height)) {
    return std::nullopt;
  }
  in.skip(name_length);
  Picture p = empty_picture(width, height);
  p.palette.resize(first + colours, {0, 0, 0, 255});
  for (std::uint32_t i = first; i < first + colours; ++i) {
    const std::uint32_t bgr = in.number(static_cast<int>(colour_bits / 8));
    const std::uint32_t alpha = colour_bits == 32 ? bgr >> 24U : 255U;
    p.palette[i] = {static_cast<std::uint8_t>(bgr >> 16U), static_cast<std::uint8_t>(bgr >> 8U),
                    static_cast<std::uint8_t>(bgr), static_cast<std::uint8_t>(alpha)};
  }
  const std::size_t count = std::size_t{width} * height;
  std::vector<std::uint8_t> codes;
  while (codes.size() < count && in.ok) {
    if (type == 1) {
      codes.push_back(in.byte());
      continue;
    }
    const std::uint32_t run = in.byte();
    const std::uint8_t code = in.byte();
    for (std::uint32_t i = 0; i <= (run & 0x7FU) && codes.size() < count; ++i) {
      codes.push_back((run & 0x80U) != 0 || i == 0 ? code : in.byte());
    }
  }
  if (!in.ok) return std::nullopt;
  p.codes.resize(count);
  const bool from_top = (flags & 0x20U) != 0;
  const bool from_right = (flags & 0x10U) != 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<std::uint32_t>(i / width);
    const auto column = static_cast<std::uint32_t>(i % width);
    p.codes[p.index(from_right ? width - 1 - column : column, from_top ? row : height - 1 - row)] =
        codes[i];
  }
  return checked(std::move(p), true);
}

}  // namespace durer::image
