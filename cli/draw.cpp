// Pictures as escape sequences.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/terminal.h"

namespace durer::cli {
namespace {

/// Cells of terminals with graphics are about this wide; it only sets the size on the screen.
constexpr int cell_pixels = 8;

struct Rgb {
  unsigned r, g, b;
};

Rgb rgb_at(const image::Image& image, int x, int y, const image::Encoding& encoding) {
  const std::uint32_t c = image::display_rgb(image, x, y, encoding);
  return {c >> 16, c >> 8 & 0xFF, c & 0xFF};
}

std::string base64(std::span<const unsigned char> bytes) {
  static constexpr char letters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < left ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      out += k <= left ? letters[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return out;
}

/// One of 216 colours: 6 levels per channel, between two levels by a 4×4 Bayer pattern.
int palette_index(const Rgb& c, int x, int y) {
  static constexpr std::array<int, 16> bayer = {0, 8,  2, 10, 12, 4, 14, 6,
                                                3, 11, 1, 9,  15, 7, 13, 5};
  const int threshold = bayer[(y % 4) * 4 + x % 4] * 51 / 16;
  const auto level = [&](unsigned v) {
    return std::min(5, (static_cast<int>(v) + threshold) / 51);
  };
  return level(c.r) * 36 + level(c.g) * 6 + level(c.b);
}

/// Six rows: for each colour in them a line of sixels, runs packed as "!n".
std::string sixel_band(const std::vector<int>& indices, int width) {
  std::array<bool, 216> used{};
  for (const int i : indices) used[i] = true;
  std::string out;
  for (int colour = 0; colour < 216; ++colour) {
    if (!used[colour]) continue;
    out += fmt::format("#{}", colour);
    for (int x = 0; x < width;) {
      const auto bits = [&](int column) {
        int b = 0;
        for (std::size_t row = 0; row * width < indices.size(); ++row) {
          if (indices[row * width + column] == colour) b |= 1 << row;
        }
        return b;
      };
      const int b = bits(x);
      int run = 1;
      while (x + run < width && bits(x + run) == b) ++run;
      const char c = static_cast<char>(63 + b);
      out += run > 3 ? fmt::format("!{}{}", run, c) : std::string(run, c);
      x += run;
    }
    out += '$';
  }
  return out + '-';
}

}  // namespace

image::Image shrunk(const image::Image& image, int columns) {
  if (image.width <= columns) return image;
  const int rows = std::max(
      1, static_cast<int>(std::lround(static_cast<double>(image.height) * columns / image.width)));
  image::Image out(columns, rows);
  const auto edge = [](int i, int from, int to) {
    return static_cast<int>(static_cast<std::int64_t>(i) * from / to);
  };
  for (int y = 0; y < rows; ++y) {
    const int y0 = edge(y, image.height, rows);
    const int y1 = std::max(y0 + 1, edge(y + 1, image.height, rows));
    for (int x = 0; x < columns; ++x) {
      const int x0 = edge(x, image.width, columns);
      const int x1 = std::max(x0 + 1, edge(x + 1, image.width, columns));
      for (int i = 0; i < 4; ++i) {
        float sum = 0;
        for (int v = y0; v < y1; ++v) {
          for (int u = x0; u < x1; ++u) sum += image.at(u, v)[i];
        }
        out.at(x, y)[i] = sum / static_cast<float>((x1 - x0) * (y1 - y0));
      }
    }
  }
  return out;
}

std::string half_blocks(const image::Image& image, const image::Encoding& encoding, int columns) {
  const image::Image small = shrunk(image, columns);
  std::string out;
  for (int y = 0; y < small.height; y += 2) {
    std::string last;
    for (int x = 0; x < small.width; ++x) {
      const Rgb top = rgb_at(small, x, y, encoding);
      std::string colours = fmt::format("\x1b[38;2;{};{};{}m", top.r, top.g, top.b);
      if (y + 1 < small.height) {
        const Rgb low = rgb_at(small, x, y + 1, encoding);
        colours += fmt::format("\x1b[48;2;{};{};{}m", low.r, low.g, low.b);
      }
      if (colours != last) out += colours;
      out += "▀";
      last = colours;
    }
    out += "\x1b[0m\n";
  }
  return out;
}

std::string kitty(const image::Image& image, const image::Encoding& encoding, int columns) {
  image::Encoding preview = encoding;
  preview.file = GammaCurve::srgb();
  preview.bits = 8;
  preview.greyscale = false;
  preview.compression = -1;
  const image::Image small = shrunk(image, columns * cell_pixels);
  const auto png = image::format_named("png")->encode(small, preview);
  if (png.error) return half_blocks(image, encoding, columns);
  const std::string data = base64(png.bytes);
  std::string out;
  for (std::size_t at = 0; at < data.size(); at += 4096) {
    const int more = at + 4096 < data.size() ? 1 : 0;
    out += fmt::format("\x1b_G{}m={};{}\x1b\\", at == 0 ? "f=100,a=T,q=2," : "", more,
                       data.substr(at, 4096));
  }
  return out + '\n';
}

std::string sixel(const image::Image& image, const image::Encoding& encoding, int columns) {
  const image::Image small = shrunk(image, columns * cell_pixels);
  std::string out = fmt::format("\x1bP0;1q\"1;1;{};{}", small.width, small.height);
  for (int i = 0; i < 216; ++i) {
    out += fmt::format("#{};2;{};{};{}", i, i / 36 * 20, i / 6 % 6 * 20, i % 6 * 20);
  }
  for (int y = 0; y < small.height; y += 6) {
    std::vector<int> band;
    for (int v = y; v < std::min(y + 6, small.height); ++v) {
      for (int x = 0; x < small.width; ++x) {
        band.push_back(palette_index(rgb_at(small, x, v, encoding), x, v));
      }
    }
    out += sixel_band(band, small.width);
  }
  return out + "\x1b\\\n";
}

std::string draw(const image::Image& image, const image::Encoding& encoding,
                 const Terminal& terminal) {
  switch (terminal.graphics) {
    case TerminalGraphics::half_blocks: return half_blocks(image, encoding, terminal.columns);
    case TerminalGraphics::kitty: return kitty(image, encoding, terminal.columns);
    case TerminalGraphics::sixel: return sixel(image, encoding, terminal.columns);
  }
  return {};
}

}  // namespace durer::cli
