// Interleaved bitmaps: a row of the first plane, of the second, …, then the next row.
#include "image/read_iff.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace durer::image {
namespace {

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;

using Data = std::vector<std::uint8_t>;

struct Chunk {
  std::string name;
  Data data;
  bool whole = true;  // false: the file ends before its data do
};

std::uint32_t number(const Data& data, std::size_t at, std::size_t bytes) {
  std::uint32_t n = 0;
  for (std::size_t i = at; i < at + bytes; ++i) n = n << 8U | (i < data.size() ? data[i] : 0U);
  return n;
}

/// Up to `size` bytes, in pieces: a size that is not true costs no memory.
Data bytes(std::FILE* file, std::uint32_t size) {
  constexpr std::uint32_t piece = 1U << 16U;
  Data data;
  while (data.size() < size) {
    const std::size_t wanted = std::min<std::size_t>(piece, size - data.size());
    const std::size_t before = data.size();
    data.resize(before + wanted);
    const std::size_t got = std::fread(data.data() + before, 1, wanted, file);
    data.resize(before + got);
    if (got < wanted) break;
  }
  return data;
}

std::optional<Chunk> next_chunk(std::FILE* file) {
  const Data head = bytes(file, 8);
  if (head.size() < 8) return std::nullopt;
  const std::uint32_t size = number(head, 4, 4);
  Chunk chunk{{head.begin(), head.begin() + 4}, bytes(file, size)};
  chunk.whole = chunk.data.size() == size;
  if (size % 2 != 0) std::fgetc(file);  // chunks begin at even places
  return chunk;
}

/// What the chunks in front of the pixels say.
struct Header {
  enum Masking : std::uint32_t { none, plane, colour, lasso };

  std::uint32_t width = 0, height = 0, planes = 0;
  std::uint32_t masking = none;
  std::uint32_t packing = 0;      // 1: runs of bytes
  std::uint32_t transparent = 0;  // index of a colour
  bool holds = false;             // pixels may hold the colour before them, and modify it
  std::vector<std::array<std::uint8_t, 4>> palette;

  void describe(const Data& data) {
    width = number(data, 0, 2);
    height = number(data, 2, 2);
    planes = number(data, 8, 1);
    masking = number(data, 9, 1);
    packing = number(data, 10, 1);
    transparent = number(data, 12, 2);
  }
  void colours(const Data& data) {
    palette.clear();
    for (std::size_t i = 0; i + 2 < data.size(); i += 3) {
      palette.push_back({data[i], data[i + 1], data[i + 2], 255});
    }
  }
  /// Six planes and 32 colours: the upper half of the codes are the same at half the light.
  void add_dim_colours() {
    if (holds || planes != 6 || palette.size() > 32) return;
    palette.resize(32, {0, 0, 0, 255});
    for (std::size_t i = 0; i < 32; ++i) {
      const auto [r, g, b, a] = palette[i];
      palette.push_back({static_cast<std::uint8_t>(r / 2), static_cast<std::uint8_t>(g / 2),
                         static_cast<std::uint8_t>(b / 2), a});
    }
  }
  /// Planes of each row, and the one of the mask.
  [[nodiscard]] std::uint32_t layers() const { return planes + (masking == plane ? 1U : 0U); }
  /// Bytes of a row of one plane: rows are whole words.
  [[nodiscard]] std::size_t stride() const { return (width + 15) / 16 * 2; }

  [[nodiscard]] std::string flaw(std::size_t body) const {
    if (width == 0 || height == 0 || std::uint64_t{width} * height > most_pixels || masking > lasso) {
      return "its header makes no sense";
    }
    if (packing > 1) return "its pixels are packed in an unknown way";
    if ((planes < 1 || planes > 8) && planes != 24) {
      return "it has " + std::to_string(planes) + " planes; 1 to 8 and 24 can be read";
    }
    if (holds && planes != 6 && planes != 8) {
      return "it modifies colours in " + std::to_string(planes) + " planes; 6 and 8 can be read";
    }
    if (planes != 24 && (palette.empty() || palette.size() > 256)) return "it has no palette";
    // A run of two bytes stands for 128 at most.
    const std::size_t size = stride() * layers() * height;
    if (size > body * (packing == 1 ? 64U : 1U)) return "it ends too early";
    return "";
  }
};

/// The bytes of the body with its runs spelled out (`ByteRun1`); zeros behind its end.
class Body {
 public:
  Body(const Data& data, bool packed) : data_(data), packed_(packed) {}

  bool ended = false;

  std::uint8_t next() {
    if (!packed_) return take();
    while (literals_ + repeats_ == 0 && !ended) {
      const std::uint8_t code = take();
      if (code < 128) literals_ = code + 1U;
      if (code > 128) {  // 128 is nothing at all
        repeats_ = 257U - code;
        value_ = take();
      }
    }
    if (literals_ == 0) return repeats_ == 0 ? std::uint8_t{0} : (--repeats_, value_);
    --literals_;
    return take();
  }

 private:
  std::uint8_t take() {
    if (at_ == data_.size()) ended = true;
    return ended ? std::uint8_t{0} : data_[at_++];
  }

  const Data& data_;
  bool packed_;
  std::size_t at_ = 0;
  unsigned literals_ = 0;
  unsigned repeats_ = 0;
  std::uint8_t value_ = 0;
};

/// Codes of all pixels, a bit from each plane, the first plane's the lowest; the mask's bits, if it
/// has a plane.
struct Pixels {
  std::vector<std::uint32_t> codes;
  std::vector<bool> opaque;

  static std::optional<Pixels> read(const Header& header, const Data& data) {
    Pixels out;
    Body body(data, header.packing == 1);
    for (std::uint32_t y = 0; y < header.height; ++y) {
      const std::size_t row = out.codes.size();
      out.codes.resize(row + header.width);
      if (header.masking == Header::plane) out.opaque.resize(row + header.width);
      for (std::uint32_t layer = 0; layer < header.layers(); ++layer) {
        std::uint8_t eight = 0;
        for (std::size_t x = 0; x < header.stride() * 8; ++x) {
          if (x % 8 == 0) eight = body.next();
          if (x >= header.width) continue;
          const std::uint32_t bit = eight >> (7 - x % 8) & 1U;
          if (layer < header.planes) {
            out.codes[row + x] |= bit << layer;
          } else {
            out.opaque[row + x] = bit != 0;
          }
        }
      }
      if (body.ended) return std::nullopt;
    }
    return out;
  }

  /// A lasso takes away what of the transparent colour is connected with the picture's border.
  void lasso(const Header& header) {
    const std::size_t w = header.width;
    const std::size_t h = header.height;
    opaque.assign(codes.size(), true);
    std::vector<std::size_t> open;
    const auto reach = [&](std::size_t x, std::size_t y) {
      if (x >= w || y >= h || !opaque[y * w + x] || codes[y * w + x] != header.transparent) return;
      opaque[y * w + x] = false;
      open.push_back(y * w + x);
    };
    for (std::size_t x = 0; x < w; ++x) reach(x, 0), reach(x, h - 1);
    for (std::size_t y = 0; y < h; ++y) reach(0, y), reach(w - 1, y);
    while (!open.empty()) {
      const std::size_t x = open.back() % w;
      const std::size_t y = open.back() / w;
      open.pop_back();
      reach(x + 1, y), reach(x - 1, y), reach(x, y + 1), reach(x, y - 1);  // below 0 is far away
    }
  }
};

using Rgb = std::array<std::uint8_t, 4>;

/// The colours of pixels one after the other: a code may keep two channels of the colour before it.
class Colours {
 public:
  explicit Colours(const Header& header)
      : header_(header), bits_(header.planes - 2) { start_row(); }

  /// Every row begins with the colour of the border.
  void start_row() { held_ = header_.palette.empty() ? Rgb{0, 0, 0, 255} : header_.palette[0]; }

  std::optional<Rgb> next(std::uint32_t code) {
    if (header_.planes == 24) {
      return Rgb{static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8U),
                 static_cast<std::uint8_t>(code >> 16U), 255};
    }
    const std::uint32_t change = header_.holds ? code >> bits_ : 0U;
    const std::uint32_t value = header_.holds ? code & ((1U << bits_) - 1) : code;
    if (change == 0) {
      if (value >= header_.palette.size()) return std::nullopt;
      return held_ = header_.palette[value];
    }
    constexpr std::array<std::size_t, 4> channel = {0, 2, 0, 1};  // blue, red, green
    std::uint8_t& held = held_[channel[change]];  // its lower bits stay
    held = static_cast<std::uint8_t>(value << (8 - bits_) | (held & ((1U << (8 - bits_)) - 1)));
    return held_;
  }

 private:
  const Header& header_;
  unsigned bits_;  // of a value
  Rgb held_{};
};

PictureRead indexed(Picture out, Header& header, const Pixels& pixels) {
  if (header.masking == Header::colour && header.transparent < header.palette.size()) {
    header.palette[header.transparent][3] = 0;
  }
  for (const std::uint32_t code : pixels.codes) {
    if (code >= header.palette.size()) return {nullptr, "its palette is too short"};
    out.codes.push_back(static_cast<std::uint16_t>(code));
  }
  out.palette = std::move(header.palette);
  return {std::make_shared<const Picture>(std::move(out)), ""};
}

PictureRead coloured(Picture out, const Header& header, const Pixels& pixels) {
  out.channels = pixels.opaque.empty() ? 3 : 4;
  Colours colours(header);
  for (std::size_t i = 0; i < pixels.codes.size(); ++i) {
    if (i % header.width == 0) colours.start_row();
    const auto colour = colours.next(pixels.codes[i]);
    if (!colour) return {nullptr, "its palette is too short"};
    out.codes.insert(out.codes.end(), colour->begin(), colour->begin() + 3);
    if (out.channels == 4) out.codes.push_back(pixels.opaque[i] ? 255 : 0);
  }
  return {std::make_shared<const Picture>(std::move(out)), ""};
}

PictureRead picture_of(Header& header, const Chunk& body) {
  header.add_dim_colours();
  if (std::string flaw = header.flaw(body.data.size()); !flaw.empty()) return {nullptr, flaw};
  auto pixels = Pixels::read(header, body.data);
  if (!pixels) return {nullptr, "it ends too early"};
  if (header.masking == Header::lasso) pixels->lasso(header);
  // A mask that hides nothing does not cost the palette.
  if (std::ranges::count(pixels->opaque, false) == 0) pixels->opaque.clear();
  Picture out;
  out.width = header.width;
  out.height = header.height;
  const bool keeps_palette = header.planes <= 8 && !header.holds && pixels->opaque.empty();
  return keeps_palette ? indexed(std::move(out), header, *pixels)
                       : coloured(std::move(out), header, *pixels);
}

}  // namespace

PictureRead read_iff(std::FILE* file) {
  const Data form = bytes(file, 12);
  if (number(form, 8, 4) != 0x494C424D) {  // "ILBM"
    return {nullptr, "it is no Amiga picture made of planes (ILBM)"};
  }
  Header header;
  bool described = false;
  while (const auto chunk = next_chunk(file)) {
    if (chunk->name == "BODY") {
      if (!described) return {nullptr, "its pixels come before its header"};
      return picture_of(header, *chunk);
    }
    if (!chunk->whole) break;
    if (chunk->name == "BMHD") {
      if (chunk->data.size() < 20) return {nullptr, "its header is too short"};
      header.describe(chunk->data);
      described = true;
    }
    if (chunk->name == "CMAP") header.colours(chunk->data);
    if (chunk->name == "CAMG") header.holds = (number(chunk->data, 0, 4) & 0x800U) != 0;
  }
  return {nullptr, "it ends before its pixels begin"};
}

}  // namespace durer::image
