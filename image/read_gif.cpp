// Graphics Interchange Format, version 89a.
#include "image/read_gif.h"

#include <array>
#include <span>

namespace durer::image {
namespace {

/// Bytes of a file; what lies behind the end is zero, and `ended` tells.
class Bytes {
 public:
  explicit Bytes(std::FILE* file) : file_(file) {}

  unsigned next() {
    const int c = std::fgetc(file_);
    if (c == EOF) ended = true;
    return c == EOF ? 0U : static_cast<unsigned>(c);
  }
  unsigned next16() {
    const unsigned low = next();
    return low | next() << 8U;
  }
  void skip(unsigned count) {
    while (count-- > 0) next();
  }
  /// The blocks of an extension, up to the empty one.
  void skip_blocks() {
    for (unsigned size = next(); size > 0 && !ended; size = next()) skip(size);
  }
  bool ended = false;

 private:
  std::FILE* file_;
};

void read_palette(Bytes& in, unsigned flags, Picture& out) {
  out.palette.clear();
  for (unsigned i = 0; i < 2U << (flags & 7U); ++i) {
    const auto red = static_cast<std::uint8_t>(in.next());
    const auto green = static_cast<std::uint8_t>(in.next());
    const auto blue = static_cast<std::uint8_t>(in.next());
    out.palette.push_back({red, green, blue, 255});
  }
}

/// The codes of a compressed picture, of a width that grows, out of blocks of bytes.
class Codes {
 public:
  explicit Codes(Bytes& in) : in_(in) {}

  unsigned next(unsigned width) {
    while (count_ < width) {
      if (left_ == 0 && !ended) {
        left_ = in_.next();
        ended = left_ == 0 || in_.ended;
      }
      if (ended) return 0;
      bits_ |= in_.next() << count_;
      count_ += 8;
      --left_;
    }
    const unsigned code = bits_ & ((1U << width) - 1);
    bits_ >>= width;
    count_ -= width;
    return code;
  }
  bool ended = false;

 private:
  Bytes& in_;
  unsigned left_ = 0;  // bytes of this block
  unsigned bits_ = 0;
  unsigned count_ = 0;
};

/// Lempel, Ziv and Welch: each code stands for a string, which is an older one and a byte more.
std::vector<std::uint8_t> expand(Bytes& in, std::size_t size) {
  constexpr unsigned most = 4096;
  struct Entry {
    std::uint16_t before;
    std::uint8_t last;
  };
  std::array<Entry, most> table{};
  std::vector<std::uint8_t> out;
  const unsigned start_width = in.next();
  if (start_width < 1 || start_width > 8) return out;
  const unsigned clear = 1U << start_width;
  unsigned width = start_width + 1;
  unsigned count = clear + 2;
  unsigned before = most;  // none
  std::uint8_t first = 0;  // byte of the string before
  std::vector<std::uint8_t> string;
  Codes codes(in);
  while (out.size() < size) {
    const unsigned code = codes.next(width);
    if (codes.ended || code == clear + 1) break;
    if (code == clear) {
      width = start_width + 1;
      count = clear + 2;
      before = most;
      continue;
    }
    if (code > count || (code == count && before == most)) break;  // no such string
    string.clear();
    unsigned at = code;
    if (code == count) {  // the string that is just being made
      string.push_back(first);
      at = before;
    }
    for (; at >= clear; at = table[at].before) string.push_back(table[at].last);
    first = static_cast<std::uint8_t>(at);
    string.push_back(first);
    out.insert(out.end(), string.rbegin(), string.rend());
    if (before != most && count < most) {
      table[count++] = {static_cast<std::uint16_t>(before), first};
      if (count == 1U << width && width < 12) ++width;
    }
    before = code;
  }
  out.resize(size);
  return out;
}

/// The rows of an interlaced picture come in four passes.
std::vector<std::uint32_t> row_order(std::uint32_t height, bool interlaced) {
  std::vector<std::uint32_t> order;
  constexpr std::array<std::array<std::uint32_t, 2>, 4> passes = {{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
  constexpr std::array<std::array<std::uint32_t, 2>, 1> whole = {{{0, 1}}};
  for (const auto& [first, step] : interlaced
                                       ? std::span<const std::array<std::uint32_t, 2>>(passes)
                                       : std::span<const std::array<std::uint32_t, 2>>(whole)) {
    for (std::uint32_t y = first; y < height; y += step) order.push_back(y);
  }
  return order;
}

}  // namespace

PictureRead read_gif(std::FILE* file) {
  Bytes in(file);
  in.skip(6 + 4);
  auto picture = std::make_shared<Picture>();
  const unsigned flags = in.next();
  in.skip(2);
  if ((flags & 0x80U) != 0) read_palette(in, flags, *picture);
  unsigned transparent = 256;
  for (;;) {
    const unsigned kind = in.next();
    if (in.ended || kind == 0x3B) return {nullptr, "there is no picture in it"};
    if (kind == 0x2C) break;
    if (kind != 0x21) return {nullptr, "it is damaged"};
    if (in.next() == 0xF9) {  // graphic control
      in.next();
      const unsigned has_transparent = in.next() & 1U;
      in.skip(2);
      const unsigned index = in.next();
      if (has_transparent != 0) transparent = index;
    }
    in.skip_blocks();
  }
  in.skip(4);
  picture->width = in.next16();
  picture->height = in.next16();
  const unsigned local = in.next();
  if ((local & 0x80U) != 0) read_palette(in, local, *picture);
  const std::size_t size = std::size_t{picture->width} * picture->height;
  if (size == 0 || picture->palette.empty()) return {nullptr, "it has no pixels or no palette"};
  const std::vector<std::uint8_t> indices = expand(in, size);
  if (indices.size() != size) return {nullptr, "it is damaged"};
  if (transparent < picture->palette.size()) picture->palette[transparent][3] = 0;
  picture->codes.resize(size);
  std::size_t from = 0;
  for (const std::uint32_t y : row_order(picture->height, (local & 0x40U) != 0)) {
    for (std::uint32_t x = 0; x < picture->width; ++x) {
      picture->codes[picture->index(x, y)] = indices[from++];
    }
  }
  return {std::move(picture), {}};
}

}  // namespace durer::image
