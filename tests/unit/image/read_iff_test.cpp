// Amiga pictures, made here plane by plane. POV-Ray 3.7 cannot read any (it looks for more chunks
// behind the pixels until the file ends, and gives up), so what is expected comes from the format's
// description; Netpbm's ilbmtoppm agrees about all kinds but masks, which it does not apply.
#include <cstdio>
#include <utility>

#include "image/read.h"
#include "tests/unit/image/read_back.h"

namespace durer::image::test {
namespace {

using Codes = std::vector<std::uint16_t>;

std::string big(std::uint32_t n, unsigned bytes) {
  std::string out;
  while (bytes-- > 0) out += static_cast<char>(n >> (8 * bytes) & 0xFFU);
  return out;
}

std::string chunk(const std::string& name, std::string data) {
  const auto size = static_cast<std::uint32_t>(data.size());
  if (size % 2 != 0) data += '\0';
  return name + big(size, 4) + data;
}

struct Ilbm {
  std::uint32_t width = 0, planes = 0;
  std::vector<std::uint32_t> codes{};
  std::string palette{};  // bytes; empty: none
  std::uint32_t mode = 0;
  std::uint32_t masking = 0, transparent = 0;
  bool packed = false;
  std::vector<bool> opaque{};  // a mask's plane, if masking is 1

  [[nodiscard]] std::uint32_t height() const { return static_cast<std::uint32_t>(codes.size()) / width; }

  [[nodiscard]] std::string row(std::size_t y, std::uint32_t plane) const {
    std::string out((width + 15) / 16 * 2, '\0');
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t i = y * width + x;
      const bool bit = plane < planes ? (codes[i] >> plane & 1U) != 0 : bool(opaque[i]);
      if (bit) out[x / 8] = static_cast<char>(static_cast<unsigned char>(out[x / 8]) | 0x80U >> x % 8);
    }
    return out;
  }
  [[nodiscard]] std::string body() const {
    std::string out;
    for (std::size_t y = 0; y < height(); ++y) {
      for (std::uint32_t plane = 0; plane < planes + (masking == 1 ? 1U : 0U); ++plane) {
        out += packed ? runs(row(y, plane)) : row(y, plane);
      }
    }
    return out;
  }
  /// Runs of equal bytes, single bytes otherwise, and a byte that says nothing.
  static std::string runs(const std::string& row) {
    std::string out = "\x80";
    for (std::size_t i = 0, count = 0; i < row.size(); i += count) {
      for (count = 1; i + count < row.size() && row[i + count] == row[i];) ++count;
      out += count == 1 ? '\0' : static_cast<char>(257 - count);
      out += row[i];
    }
    return out;
  }
  [[nodiscard]] std::string header() const {
    return chunk("BMHD", big(width, 2) + big(height(), 2) + big(0, 4) + big(planes, 1) +
                             big(masking, 1) + big(packed ? 1 : 0, 1) + big(0, 1) +
                             big(transparent, 2) + big(0x0101, 2) + big(width, 2) + big(height(), 2));
  }
  [[nodiscard]] std::string file() const {
    std::string chunks = header() + chunk("XXXX", "odd");
    if (!palette.empty()) chunks += chunk("CMAP", palette);
    if (mode != 0) chunks += chunk("CAMG", big(mode, 4));
    chunks += chunk("BODY", body());
    return "FORM" + big(static_cast<std::uint32_t>(chunks.size()) + 4, 4) + "ILBM" + chunks;
  }
};

PictureRead read_bytes(const std::string& bytes) {
  const Folder folder;
  const std::string path = folder / "a.iff";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  REQUIRE(file != nullptr);
  std::fwrite(bytes.data(), 1, bytes.size(), file);
  std::fclose(file);
  return image::read(path);
}

Picture picture(const Ilbm& ilbm) {
  const PictureRead read = read_bytes(ilbm.file());
  CAPTURE(read.error);
  REQUIRE(read.picture);
  CHECK(read.picture->width == ilbm.width);
  CHECK(read.picture->height == ilbm.height());
  return *read.picture;
}

/// Greys 0, 1, 2, … in three channels that differ.
std::string ramp(unsigned colours) {
  std::string out;
  for (unsigned i = 0; i < colours; ++i) out += big(i << 16U | (i + 64) << 8U | (i + 128), 3);
  return out;
}

}  // namespace

TEST_CASE("read: an ILBM's planes are indices, in runs or not", "[image][read][iff]") {
  const std::uint32_t planes = GENERATE(1U, 2U, 3U, 4U, 5U, 7U, 8U);
  const bool packed = GENERATE(false, true);
  CAPTURE(planes, packed);
  Ilbm p{.width = 19, .planes = planes, .palette = ramp(1U << planes), .packed = packed};
  Codes expected;
  for (std::uint32_t i = 0; i < 19 * 3; ++i) {
    p.codes.push_back(i * 11 % (1U << planes));
    expected.push_back(static_cast<std::uint16_t>(p.codes.back()));
  }
  const Picture read = picture(p);
  CHECK(read.codes == expected);
  REQUIRE(read.palette.size() == 1U << planes);
  CHECK(read.palette[1] == std::array<std::uint8_t, 4>{1, 65, 129, 255});
}

TEST_CASE("read: 24 planes are red, green and blue", "[image][read][iff]") {
  const Picture read = picture({.width = 2, .planes = 24, .codes = {0x030201, 0xFF0080}});
  CHECK(read.palette.empty());
  CHECK(read.channels == 3);
  CHECK(read.codes == Codes{1, 2, 3, 0x80, 0, 0xFF});
}

TEST_CASE("read: an ILBM's held colours change one channel at a time", "[image][read][iff]") {
  // Each row begins with colour 0. Upper bits are replaced, the others stay.
  const std::string palette = big(0x111213, 3) + big(0x212223, 3);
  Ilbm six{.width = 3, .planes = 6, .codes = {0x1A, 1, 0x2F, 0x3C, 0x05, 0x20}, .mode = 0x800};
  six.palette = palette + ramp(14);
  CHECK(picture(six).codes == Codes{0x11, 0x12, 0xA3, 0x21, 0x22, 0x23, 0xF1, 0x22, 0x23,  //
                                    0x11, 0xC2, 0x13, 0x03, 0x43, 0x83, 0x03, 0x43, 0x83});
  Ilbm eight{.width = 3, .planes = 8, .codes = {0x7F, 1, 0x81}, .mode = 0x800};
  eight.palette = palette + ramp(62);
  CHECK(picture(eight).codes == Codes{0x11, 0x12, 0xFF, 0x21, 0x22, 0x23, 0x05, 0x22, 0x23});
}

TEST_CASE("read: six planes and 32 colours have 32 dim ones", "[image][read][iff]") {
  const std::uint32_t mode = GENERATE(0U, 0x80U);
  const Picture read = picture({.width = 2, .planes = 6, .codes = {33, 63}, .palette = ramp(32), .mode = mode});
  CHECK(read.codes == Codes{33, 63});
  REQUIRE(read.palette.size() == 64);
  CHECK(read.palette[63] == std::array<std::uint8_t, 4>{15, 47, 79, 255});
}

TEST_CASE("read: an ILBM's mask and transparent colour are alpha", "[image][read][iff]") {
  Ilbm p{.width = 3, .planes = 2, .codes = {0, 1, 0, 1, 0, 1, 2, 1, 0}, .palette = ramp(4)};
  p.masking = 2;
  p.transparent = 1;
  const Picture coloured = picture(p);
  CHECK(coloured.palette[1][3] == 0);
  CHECK(coloured.palette[0][3] == 255);

  const auto alphas = [](const Picture& read) {
    REQUIRE(read.channels == 4);
    Codes out;
    for (std::size_t i = 3; i < read.codes.size(); i += 4) out.push_back(read.codes[i]);
    return out;
  };
  p.masking = 1;
  p.opaque = {true, false, true, true, false, true, true, true, false};
  p.packed = GENERATE(false, true);
  const Picture masked = picture(p);
  CHECK(alphas(masked) == Codes{255, 0, 255, 255, 0, 255, 255, 255, 0});
  CHECK(masked.codes[masked.index(0, 2, 1)] == 66);
  p.opaque.assign(9, true);
  CHECK(picture(p).palette.size() == 4);  // nothing is hidden: still indices

  p.masking = 3;  // of the transparent colour, what is connected with the border
  p.transparent = 0;
  p.codes = {1, 1, 1, 1, 0, 1, 1, 1, 0};
  CHECK(alphas(picture(p)) == Codes{255, 255, 255, 255, 255, 255, 255, 255, 0});
}

TEST_CASE("read: an ILBM that is damaged says so", "[image][read][iff]") {
  Ilbm p{.width = 5, .planes = 3, .codes = std::vector<std::uint32_t>(10, 7), .palette = ramp(8)};
  p.packed = GENERATE(false, true);
  const std::string whole = p.file();
  REQUIRE(read_bytes(whole).picture);
  for (std::size_t size = 4; size < whole.size(); ++size) {
    CAPTURE(size);
    const PictureRead read = read_bytes(whole.substr(0, size));
    CHECK_FALSE(read.picture);
    CHECK_FALSE(read.error.empty());
  }
  for (std::size_t at = 4; at < whole.size(); ++at) {  // none may crash, or take all memory
    for (const unsigned byte : {0x00U, 0x7FU, 0x80U, 0xFFU}) {
      std::string changed = whole;
      changed[at] = static_cast<char>(byte);
      const PictureRead read = read_bytes(changed);
      CHECK((read.picture != nullptr) == read.error.empty());
    }
  }
}

TEST_CASE("read: an ILBM's errors say what is wrong", "[image][read][iff]") {
  const auto error = [](Ilbm p) { return read_bytes(p.file()).error; };
  const Ilbm good{.width = 1, .planes = 3, .codes = {7}, .palette = ramp(8)};
  Ilbm p = good;
  p.planes = 12;
  CHECK(error(p) == "it has 12 planes; 1 to 8 and 24 can be read");
  p = good;
  p.palette = "";
  CHECK(error(p) == "it has no palette");
  p.palette = ramp(7);
  CHECK(error(p) == "its palette is too short");
  p = good;
  p.mode = 0x800;
  CHECK(error(p) == "it modifies colours in 3 planes; 6 and 8 can be read");
  CHECK(read_bytes("FORM" + big(4, 4) + "AIFF").error == "it is no Amiga picture made of planes (ILBM)");
  CHECK(read_bytes("FORM" + big(4, 4) + "ILBM" + good.header()).error == "it ends before its pixels begin");
  CHECK(read_bytes("FORM" + big(4, 4) + "ILBM" + chunk("BODY", "")).error ==
        "its pixels come before its header");
  // A header of four thousand million pixels, with nothing behind it.
  std::string huge = good.file();
  huge.replace(huge.find("BMHD") + 8, 4, 4, '\xFF');
  CHECK(read_bytes(huge).error == "its header makes no sense");
}

}  // namespace durer::image::test
