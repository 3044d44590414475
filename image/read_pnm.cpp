#include "image/read_pnm.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace durer::image {
namespace {

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;

/// The next number of the header or of a text, past blanks and comments.
std::optional<std::uint32_t> number(std::FILE* file) {
  int c = std::fgetc(file);
  while (c != EOF && (std::isspace(c) != 0 || c == '#')) {
    if (c == '#') {
      while (c != EOF && c != '\n') c = std::fgetc(file);
    }
    c = std::fgetc(file);
  }
  if (c == EOF || std::isdigit(c) == 0) return std::nullopt;
  std::uint32_t value = 0;
  while (c != EOF && std::isdigit(c) != 0 && value < 10'000'000) {
    value = value * 10 + static_cast<std::uint32_t>(c - '0');
    c = std::fgetc(file);  // one blank behind the number belongs to it
  }
  return value;
}

/// Samples that are written as text, or as bits, one after the other.
class Samples {
 public:
  Samples(std::FILE* file, char kind, std::uint32_t width)
      : file_(file), kind_(kind), width_(width) {}

  std::optional<std::uint32_t> next() {
    if (kind_ == '1') return bit_of_text();
    return kind_ == '4' ? packed_bit() : number(file_);
  }

 private:
  /// 1 is black.
  std::optional<std::uint32_t> bit_of_text() {
    int c = std::fgetc(file_);
    while (c != EOF && std::isspace(c) != 0) c = std::fgetc(file_);
    if (c != '0' && c != '1') return std::nullopt;
    return c == '0' ? 1U : 0U;
  }
  std::optional<std::uint32_t> packed_bit() {
    if (column_ % 8 == 0) {
      byte_ = std::fgetc(file_);
      if (byte_ == EOF) return std::nullopt;
    }
    const bool black = (byte_ >> (7 - column_ % 8) & 1) != 0;
    if (++column_ == width_) column_ = 0;
    return black ? 0U : 1U;
  }

  std::FILE* file_;
  char kind_;
  std::uint32_t width_;
  std::uint32_t column_ = 0;
  int byte_ = 0;
};

/// Appends `count` samples that are written as bytes, or as two of them; false if there are not so
/// many.
bool read_bytes(std::FILE* file, bool wide, std::size_t count, std::vector<std::uint16_t>& out) {
  constexpr std::size_t likely = 1 << 23;  // a broken header may promise any number
  out.reserve(std::min(count, likely));
  std::array<unsigned char, 1 << 14> block;
  const std::size_t size = wide ? 2 : 1;
  while (count > 0) {
    const std::size_t wanted = std::min(count, block.size() / size);
    if (std::fread(block.data(), size, wanted, file) != wanted) return false;
    const std::size_t before = out.size();
    out.resize(before + wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
      const int sample = wide ? block[2 * i] << 8 | block[2 * i + 1] : block[i];
      out[before + i] = static_cast<std::uint16_t>(sample);
    }
    count -= wanted;
  }
  return true;
}

bool read_others(Samples samples, std::size_t count, std::uint32_t unit,
                 std::vector<std::uint16_t>& out) {
  for (; count > 0; --count) {
    const auto value = samples.next();
    if (!value) return false;
    out.push_back(static_cast<std::uint16_t>(unit * *value));
  }
  return true;
}

}  // namespace

PictureRead read_pnm(std::FILE* file) {
  std::fgetc(file);
  const char kind = static_cast<char>(std::fgetc(file));
  const auto width = number(file);
  const auto height = number(file);
  const bool bits = kind == '1' || kind == '4';
  const auto most = bits ? std::optional<std::uint32_t>(1) : number(file);
  if (!width || !height || !most || *width == 0 || *height == 0 || *most == 0 || *most > 65535 ||
      std::uint64_t{*width} * *height > most_pixels) {
    return {nullptr, "its header makes no sense"};
  }
  auto picture = std::make_shared<Picture>();
  picture->width = *width;
  picture->height = *height;
  picture->channels = kind == '3' || kind == '6' ? 3 : 1;
  picture->bits = bits || *most == 255 ? 8 : *most == 65535 ? 16 : 32;
  const std::size_t count = std::size_t{*width} * *height * picture->channels;
  const bool whole =
      kind > '4' ? read_bytes(file, *most > 255, count, picture->codes)
                 : read_others({file, kind, *width}, count, bits ? 255 : 1, picture->codes);
  if (!whole) return {nullptr, "it ends too early"};
  if (picture->is_real()) {
    const auto share = [&](std::uint32_t code) {
      return static_cast<float>(code) / static_cast<float>(*most);
    };
    picture->samples.reserve(count);
    for (const std::uint16_t code : picture->codes) picture->samples.push_back(share(code));
    picture->codes = {};
  }
  return {std::move(picture), {}};
}

}  // namespace durer::image
