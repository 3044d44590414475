#include "image/read_pnm.h"

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

/// Samples one after the other, as the kind of file has them.
class Samples {
 public:
  Samples(std::FILE* file, char kind, std::uint32_t most, std::uint32_t width)
      : file_(file), kind_(kind), wide_(most > 255), width_(width) {}

  std::optional<std::uint32_t> next() {
    if (kind_ == '1') return bit_of_text();
    if (kind_ == '4') return packed_bit();
    if (kind_ < '4') return number(file_);
    const int high = std::fgetc(file_);
    if (!wide_) return high == EOF ? std::nullopt : std::optional(static_cast<std::uint32_t>(high));
    const int low = std::fgetc(file_);
    if (low == EOF) return std::nullopt;
    return static_cast<std::uint32_t>(high << 8 | low);
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
  bool wide_;
  std::uint32_t width_;
  std::uint32_t column_ = 0;
  int byte_ = 0;
};

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
  Samples samples(file, kind, *most, *width);
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = samples.next();
    if (!value) return {nullptr, "it ends too early"};
    if (picture->is_real()) {
      picture->samples.push_back(static_cast<float>(*value) / static_cast<float>(*most));
    } else {
      picture->codes.push_back(static_cast<std::uint16_t>(bits ? 255 * *value : *value));
    }
  }
  return {std::move(picture), {}};
}

}  // namespace durer::image
